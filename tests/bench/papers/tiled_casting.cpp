// What rays over tiles save (Dick, Krüger & Westermann 2009, figure 6 and sections 3.2 and 3.4): by the
// pyramid in each tile, by ending at the first hit, and by Talus's beams.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "render/hits_target.h"
#include "render/tiled/tiled_rays.h"
#include "sim/error.h"
#include "tests/bench/measure.h"
#include "tests/bench/papers/table.h"
#include "tests/bench/papers/tables.h"
#include "tests/bench/papers/terrains.h"
#include "tests/scenes/load_tiles.h"

namespace talus::bench {
namespace {

constexpr glm::ivec2 cast_picture(1280, 720);
constexpr double cast_px = 2.0 / 3;

struct Way {
    std::string name;
    std::vector<std::string> defines;  // of shaders/render/tiled.frag
};

const std::vector<Way>& ways() {
    static const std::vector<Way> all = {{"rays", {"NO_BEAMS"}},
                                         {"finest level", {"NO_BEAMS", "FINEST_LEVEL"}},
                                         {"every tile", {"NO_BEAMS", "EVERY_TILE"}}};
    return all;
}

// All tiles there that a picture wants.
class CastPicture {
  public:
    CastPicture(const scenes::MemoryTiles& tiles, const render::Camera& camera)
        : camera_(camera),
          surface_(tiles.tree(), tiles.bounds(), static_cast<int>(tiles.tree().count())),
          target_(cast_picture.x, cast_picture.y) {
        scenes::put_coarsest(surface_, tiles);
        scenes::load_tiles(surface_, tiles, camera, cast_picture, cast_px);
    }

    void cast(gpu::Program& program) {
        surface_.bind(program, camera_, cast_picture);
        target_.framebuffer().bind({0, 0, cast_picture.x, cast_picture.y});
        program.draw_fullscreen();
    }
    void cast(render::TiledRays& rays) { rays.cast(surface_, camera_, cast_picture, target_.framebuffer()); }
    void wait() { target_.read_distances(1, 1); }
    std::vector<float> distances() { return target_.read_distances(cast_picture.x, cast_picture.y); }
    std::vector<float> details() { return target_.read_details(cast_picture.x, cast_picture.y); }

  private:
    render::Camera camera_;
    render::TiledSurface surface_;
    render::HitsTarget target_;
};

gpu::Program program_of(const Way& way, bool counting) {
    std::vector<std::string> defines = way.defines;
    if (counting) defines.emplace_back("COUNT_STEPS");
    return gpu::Program({"render/fullscreen.vert", "render/tiled.frag"}, defines);
}

// Steps of the rays that hit ground.
struct Steps {
    double mean = 0;
    float half_within = 0;
    float nine_tenths_within = 0;
    double above_50 = 0;
};

Steps spread_of(std::vector<float> visited) {
    std::sort(visited.begin(), visited.end());
    const auto count = static_cast<double>(visited.size());
    const auto above = visited.end() - std::upper_bound(visited.begin(), visited.end(), 50.0F);
    return {std::accumulate(visited.begin(), visited.end(), 0.0) / count, visited[visited.size() / 2],
            visited[visited.size() * 9 / 10], static_cast<double>(above) / count};
}

// Of one camera: steps of each way are appended to `visited`, milliseconds are added.
void race_ways(CastPicture& picture, std::vector<std::vector<float>>& visited, std::vector<double>& ms) {
    std::vector<Contestant> contestants;
    std::vector<gpu::Program> programs;
    programs.reserve(ways().size());
    std::vector<float> expected;
    render::TiledRays with_beams(render::Detail::none);
    for (std::size_t i = 0; i < ways().size(); ++i) {
        gpu::Program counting = program_of(ways()[i], true);
        picture.cast(counting);
        const std::vector<float> distances = picture.distances();
        const std::vector<float> steps = picture.details();
        if (i == 0) expected = distances;
        if (distances != expected)
            throw Error(fmt::format("tiled_casting: rays of '{}' end elsewhere", ways()[i].name));
        for (std::size_t p = 0; p < steps.size(); ++p)
            if (!std::isinf(distances[p])) visited[i].push_back(steps[p]);
        gpu::Program& program = programs.emplace_back(program_of(ways()[i], false));
        contestants.push_back({ways()[i].name, [&picture, &program] {
                                   picture.cast(program);
                                   picture.wait();
                               }});
    }
    contestants.push_back({"beams", [&] {
                               picture.cast(with_beams);
                               picture.wait();
                           }});
    const std::vector<double> times = interleave(contestants, 5);
    for (std::size_t i = 0; i < times.size(); ++i) ms[i] += 1e3 * times[i];
}

}  // namespace

void tiled_casting(const PaperRun& run) {
    Table table("tiled_casting",
                "terrain,pictures,way,ms,mean_steps,half_within,nine_tenths_within,above_50_percent");
    for (const std::string& name : run.terrains) {
        const PaperTerrain terrain = paper_terrain(name);
        const scenes::MemoryTiles tiles(terrain.grid, terrain.heights, 256);
        for (const bool walks : {false, true}) {
            std::vector<std::vector<float>> visited(ways().size());
            std::vector<double> ms(ways().size() + 1, 0);
            const auto cameras = walks ? paper_walk(terrain, 3) : paper_flight(terrain, 3);
            for (const render::Camera& camera : cameras) {
                CastPicture picture(tiles, camera);
                race_ways(picture, visited, ms);
            }
            const auto row = [&](const std::string& way, double of_way_ms, const std::string& steps) {
                table.row(fmt::format("{},{},{},{:.1f},{}", name, walks ? "walk" : "fly", way,
                                      of_way_ms / static_cast<double>(cameras.size()), steps));
            };
            for (std::size_t i = 0; i < ways().size(); ++i) {
                const Steps steps = spread_of(std::move(visited[i]));
                row(ways()[i].name, ms[i],
                    fmt::format("{:.1f},{},{},{:.2f}", steps.mean, steps.half_within,
                                steps.nine_tenths_within, 100 * steps.above_50));
            }
            row("rays from beams", ms.back(), ",,,");
        }
    }
}

}  // namespace talus::bench

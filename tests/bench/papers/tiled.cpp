// Terrain in tiles of several levels (Dick, Krüger & Westermann 2009), all tiles on the device: time by
// tolerance, against exact rays over the whole.
#include <fmt/format.h>

#include "render/hits_target.h"
#include "render/survey.h"
#include "render/tiled/tiled_rays.h"
#include "tests/bench/measure.h"
#include "tests/bench/papers/easel.h"
#include "tests/bench/papers/table.h"
#include "tests/bench/papers/tables.h"
#include "tests/scenes/memory_tiles.h"

namespace talus::bench {
namespace {

constexpr glm::ivec2 whole_picture(1280, 720);

// One tolerance, with a surface of its own whose tiles are all there.
class TiledPicture {
  public:
    TiledPicture(const scenes::MemoryTiles& tiles, const render::Camera& camera, double tolerance_px)
        : camera_(camera),
          surface_(tiles.tree(), tiles.bounds(), static_cast<int>(tiles.tree().count())),
          target_(whole_picture.x, whole_picture.y) {
        const int top = tiles.tree().top_level();
        for (int row = 0; row < tiles.tree().level(top).tiles.y; ++row)
            for (int column = 0; column < tiles.tree().level(top).tiles.x; ++column)
                surface_.put({top, column, row}, tiles.read({top, column, row}));
        for (;;) {
            choice = surface_.look(camera, whole_picture, tolerance_px);
            if (choice.wanted.empty()) return;
            for (const TileId& tile : choice.wanted) surface_.put(tile, tiles.read(tile));
        }
    }

    double mean_steps() {
        render::TiledRays rays(render::Detail::steps);
        rays.cast(surface_, camera_, whole_picture, target_.framebuffer());
        double sum = 0;
        for (float s : target_.read_details(whole_picture.x, whole_picture.y)) sum += s;
        return sum / (whole_picture.x * whole_picture.y);
    }

    // The choice of tiles and the rays. Waits for the device.
    void draw() {
        choice = surface_.look(camera_, whole_picture, choice.tolerance_px);
        rays_.cast(surface_, camera_, whole_picture, target_.framebuffer());
        const std::vector<float> wait = target_.read_distances(1, 1);
    }

    render::TileChoice choice;

  private:
    render::Camera camera_;
    render::TiledSurface surface_;
    render::HitsTarget target_;
    render::TiledRays rays_{render::Detail::none};
};

}  // namespace

void tiled(const PaperRun& run) {
    Table table("tiled", "terrain,pictures,way,ms,tiles");
    for (const std::string& name : run.terrains) {
        const PaperTerrain terrain = paper_terrain(name);
        const scenes::MemoryTiles tiles(terrain.grid, terrain.heights, 256);
        PaperEasel easel(terrain, whole_picture, run.patch_pixels);
        const Entry exact = entry("exact");
        const double width_m = terrain.grid.width_m();
        const glm::dvec3 middle(0.5 * width_m, 0.5 * terrain.grid.height_m(), 0);
        const std::vector<render::NamedCamera> views = {
            {"flight", paper_flight(terrain, 5)[1]},
            {"walk", paper_walk(terrain, 5)[1]},
            {"high", {middle + glm::dvec3(0, -0.9, 0.9) * width_m, middle, 45}}};
        for (const render::NamedCamera& view : views) {
            std::vector<Contestant> contestants = {{"exact", [&] { easel.draw(exact, view.camera); }}};
            std::vector<TiledPicture> pictures;
            const std::vector<double> tolerances_px = {0, 2.0 / 3, 2};
            pictures.reserve(tolerances_px.size());
            for (const double tolerance_px : tolerances_px) {
                TiledPicture& picture = pictures.emplace_back(tiles, view.camera, tolerance_px);
                contestants.push_back(
                    {fmt::format("{:.2f} px", tolerance_px), [&picture] { picture.draw(); }});
            }
            for (auto& p : pictures) fmt::print("steps {:.1f}\n", p.mean_steps());
            const std::vector<double> times = interleave(contestants, 9);
            for (std::size_t i = 0; i < times.size(); ++i)
                table.row(fmt::format("{},{},{},{:.1f},{}", name, view.name, contestants[i].name,
                                      1e3 * times[i], i == 0 ? 0 : pictures[i - 1].choice.drawn.size()));
        }
    }
}

}  // namespace talus::bench

// Terrain in tiles of several levels (Dick, Krüger & Westermann 2009), all tiles on the device: time by
// tolerance, against exact rays over the whole.
#include <fmt/format.h>

#include <numeric>

#include "render/hits_target.h"
#include "render/survey.h"
#include "render/tiled/tiled_rays.h"
#include "tests/bench/measure.h"
#include "tests/bench/papers/easel.h"
#include "tests/bench/papers/table.h"
#include "tests/bench/papers/tables.h"
#include "tests/scenes/load_tiles.h"

namespace talus::bench {
namespace {

constexpr glm::ivec2 whole_picture(1280, 720);

// The room of tiles.gpu_mib unless set; without tolerance, for all tiles.
int slots_for(const TileTree& tree, double tolerance_px) {
    const std::size_t usual = (std::size_t{128} << 20) / render::TiledSurface::bytes_of_slot(tree);
    return static_cast<int>(tolerance_px > 0 ? std::min(usual, tree.count()) : tree.count());
}

// One tolerance, with a surface of its own whose tiles are all there.
class TiledPicture {
  public:
    TiledPicture(const scenes::MemoryTiles& tiles, const render::Camera& camera, double tolerance_px)
        : camera_(camera),
          surface_(tiles.tree(), tiles.bounds(), slots_for(tiles.tree(), tolerance_px)),
          target_(whole_picture.x, whole_picture.y) {
        scenes::put_coarsest(surface_, tiles);
        choice = scenes::load_tiles(surface_, tiles, camera, whole_picture, tolerance_px);
    }

    // The choice of tiles and the rays. Waits for the device.
    void draw() {
        choice = surface_.look(camera_, whole_picture, choice.tolerance_px);
        rays_.cast(surface_, camera_, whole_picture, target_.framebuffer());
        const std::vector<float> wait = target_.read_distances(1, 1);
    }

    // Nodes, cells and patches that a ray visits, on average.
    double mean_steps() {
        render::TiledRays counting(render::Detail::steps);
        counting.cast(surface_, camera_, whole_picture, target_.framebuffer());
        const std::vector<float> steps = target_.read_details(whole_picture.x, whole_picture.y);
        return std::accumulate(steps.begin(), steps.end(), 0.0) / static_cast<double>(steps.size());
    }

    render::TileChoice choice;

  private:
    render::Camera camera_;
    render::TiledSurface surface_;
    render::HitsTarget target_;
    render::TiledRays rays_{render::Detail::none};
};

// A camera's picture by methods over the whole and by tiles.
void race(Table& table, const PaperTerrain& terrain, const scenes::MemoryTiles& tiles, PaperEasel& easel,
          const std::vector<Entry>& methods, const render::NamedCamera& view) {
    const std::vector<double> tolerances_px = {0, 2.0 / 3, 2};
    std::vector<Contestant> contestants;
    contestants.reserve(methods.size() + tolerances_px.size());
    for (const Entry& method : methods)
        contestants.push_back({method.name, [&] { easel.draw(method, view.camera); }});
    std::vector<TiledPicture> pictures;
    pictures.reserve(tolerances_px.size());
    for (const double tolerance_px : tolerances_px) {
        TiledPicture& picture = pictures.emplace_back(tiles, view.camera, tolerance_px);
        contestants.push_back({fmt::format("{:.2f} px", tolerance_px), [&picture] { picture.draw(); }});
    }
    const std::vector<double> times = interleave(contestants, 9);
    for (std::size_t i = 0; i < times.size(); ++i) {
        std::string row =
            fmt::format("{},{},{},{:.1f}", terrain.name, view.name, contestants[i].name, 1e3 * times[i]);
        if (i < methods.size()) {
            table.row(row + ",,");
            continue;
        }
        TiledPicture& picture = pictures[i - methods.size()];
        table.row(row + fmt::format(",{},{:.1f}", picture.choice.drawn.size(), picture.mean_steps()));
    }
}

render::NamedCamera high_view(const Grid& grid) {
    const glm::dvec3 middle(0.5 * grid.width_m(), 0.5 * grid.height_m(), 0);
    return {"high", {middle + glm::dvec3(0, -0.9, 0.9) * grid.width_m(), middle, 45}};
}

constexpr const char* columns = "terrain,pictures,way,ms,tiles,steps";

}  // namespace

void tiled(const PaperRun& run) {
    Table table("tiled", columns);
    for (const std::string& name : run.terrains) {
        const PaperTerrain terrain = paper_terrain(name);
        const scenes::MemoryTiles tiles(terrain.grid, terrain.heights, 256);
        PaperEasel easel(terrain, whole_picture, run.patch_pixels);
        for (const render::NamedCamera& view :
             {render::NamedCamera{"flight", paper_flight(terrain, 5)[1]},
              render::NamedCamera{"walk", paper_walk(terrain, 5)[1]}, high_view(terrain.grid)})
            race(table, terrain, tiles, easel, {entry("exact")}, view);
    }
}

void tiled_8192(const PaperRun& run) {
    Table table("tiled_8192", columns);
    const PaperTerrain terrain = paper_terrain_of(8192);
    const scenes::MemoryTiles tiles(terrain.grid, terrain.heights, 256);
    PaperEasel easel(terrain, whole_picture, run.patch_pixels);
    race(table, terrain, tiles, easel, {entry("exact"), entry("mesh"), entry("clipmap")},
         high_view(terrain.grid));
}

}  // namespace talus::bench

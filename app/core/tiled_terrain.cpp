#include "app/core/tiled_terrain.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/core/long_work.h"
#include "sim/error.h"
#include "sim/io/tile_sidecar.h"

namespace talus::app {
namespace {

// Tiles of the coarsest level, which are held always.
constexpr int most_coarsest_tiles = 64;

}  // namespace

glm::vec2 heights_of(const std::vector<TileBounds>& bounds) {
    glm::vec2 heights(bounds.front().lowest_m, bounds.front().highest_m);
    for (const TileBounds& one : bounds)
        heights = {std::min(heights.x, one.lowest_m), std::max(heights.y, one.highest_m)};
    return heights;
}

TiledTerrain open_tiled(const std::string& path, const io::ImportSettings& import) {
    io::TiledFile file(path, import);
    TileTree tree(file.grid(), tile_patches, file.levels(), file.level_places());
    const glm::ivec2 coarsest = tree.levels().back().tiles;
    if (static_cast<std::int64_t>(coarsest.x) * coarsest.y > most_coarsest_tiles)
        throw Error(fmt::format(
            "'{}' has too few overviews to be shown as a whole: 'talus tile' writes a file that has them",
            path));
    std::vector<std::string> notes = file.notes();
    std::optional<std::vector<TileBounds>> bounds = io::read_tile_sidecar(file, tree);
    if (!bounds) {
        LongWork work(fmt::format("measuring '{}'", path));
        bounds = measure_tile_bounds(
            tree, [&] { return file.make_reader(); }, [&](double share) { return work(share); });
        if (bounds->empty()) throw Error(fmt::format("interrupted while '{}' was measured", path));
        try {
            io::write_tile_sidecar(file, tree, *bounds);
        } catch (const Error& error) {
            notes.push_back(fmt::format("the bounds of its tiles are measured each time: {}", error.what()));
        }
    }
    TiledTerrain terrain{std::move(file), std::move(tree), std::move(*bounds), std::move(notes)};
    const glm::vec2 heights = heights_of(terrain.bounds);
    terrain.lowest_m = heights.x;
    terrain.highest_m = heights.y;
    return terrain;
}

}  // namespace talus::app

#include "app/core/tiled_terrain.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "app/core/long_work.h"
#include "render/tiled/tiled_surface.h"
#include "sim/error.h"
#include "sim/io/tile_sidecar.h"

namespace talus::app {
namespace {

// Tiles of the coarsest level, which are held always.
constexpr std::size_t most_coarsest_tiles = 64;

TileTree tree_of(const io::TiledFile& file) {
    TileTree tree(file.grid(), tile_patches, file.levels(), file.level_places());
    if (tree.coarsest_tiles().size() > most_coarsest_tiles)
        throw Error(fmt::format(
            "'{}' has too few overviews to be shown as a whole: 'talus tile' writes a file that has them",
            file.path().string()));
    return tree;
}

}  // namespace

glm::vec2 heights_of(const std::vector<TileBounds>& bounds) {
    glm::vec2 heights(bounds.front().lowest_m, bounds.front().highest_m);
    for (const TileBounds& one : bounds)
        heights = {std::min(heights.x, one.lowest_m), std::max(heights.y, one.highest_m)};
    return heights;
}

std::function<Progress(const std::string& path)> on_terminal() {
    return [](const std::string& path) -> Progress {
        const auto work = std::make_shared<LongWork>(fmt::format("measuring '{}'", path));
        return [work](double share) { return (*work)(share); };
    };
}

TiledTerrain open_tiled(const std::string& path, const io::ImportSettings& import,
                        const std::function<Progress(const std::string& path)>& begin_progress) {
    io::TiledFile file(path, import);
    TileTree tree = tree_of(file);
    std::vector<std::string> notes = file.notes();
    std::optional<std::vector<TileBounds>> bounds = io::read_tile_sidecar(file, tree);
    if (!bounds) {
        bounds = measure_tile_bounds(
            tree, [&] { return file.make_reader(); }, begin_progress(path));
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

bool is_measured(const std::string& path, const io::ImportSettings& import) {
    const io::TiledFile file(path, import);
    return io::read_tile_sidecar(file, tree_of(file)).has_value();
}

void keep_bounds_of_mosaic(const io::CutOut& whole, const std::string& mosaic, const TileSamples& patch) {
    try {
        const io::TiledFile before(whole.path, whole.import);
        const TileTree tree = tree_of(before);
        std::optional<std::vector<TileBounds>> bounds = io::read_tile_sidecar(before, tree);
        if (!bounds || before.source().void_value || before.level_places() != LevelPlaces::by_halves) return;
        const io::TiledFile after(mosaic, {});
        const BoundsBefore known{std::move(*bounds), patch};
        io::write_tile_sidecar(after, tree,
                               measure_tile_bounds(
                                   tree, [&] { return after.make_reader(); }, {}, &known));
    } catch (const Error&) {
        // It is measured when it is opened, and what is wrong is said there.
    }
}

int slots_within(const TiledTerrain& terrain, int gpu_mib) {
    const std::size_t room = static_cast<std::size_t>(gpu_mib) << 20;
    const std::size_t beside = std::min(room, render::TiledSurface::bytes_of_nodes(terrain.tree));
    const std::size_t slots =
        std::min((room - beside) / render::TilePool::bytes_of_slot(terrain.tree), terrain.tree.count() + 1);
    const std::size_t coarsest = terrain.tree.coarsest_tiles().size();
    if (slots <= coarsest)
        throw Error(fmt::format(
            "tiles.gpu_mib = {} holds {} tiles, '{}' needs more than the {} of its coarsest level", gpu_mib,
            slots, terrain.file.path().string(), coarsest));
    return static_cast<int>(slots);
}

}  // namespace talus::app

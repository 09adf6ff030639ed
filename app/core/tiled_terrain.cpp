#include "app/core/tiled_terrain.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/core/long_work.h"
#include "app/core/tile_room.h"
#include "render/tiled/tiled_surface.h"
#include "sim/error.h"
#include "sim/io/tile_sidecar.h"
#include "sim/io/tile_writer.h"

namespace talus::app {
namespace {

// Tiles of the coarsest level, which are held always.
constexpr std::size_t most_coarsest_tiles = 64;

bool is_wide(const TileTree& tree) {
    return tree.coarsest_tiles().size() > most_coarsest_tiles;
}

TiledTerrain with_bounds(io::TiledFile file, TileTree tree, std::vector<TileBounds> bounds,
                         std::vector<std::string> notes) {
    const glm::vec2 heights = heights_of(bounds);
    TiledTerrain terrain{std::move(file), std::move(tree), std::move(bounds), std::move(notes)};
    terrain.lowest_m = heights.x;
    terrain.highest_m = heights.y;
    return terrain;
}

}  // namespace

bool is_same(const TiledRequest& a, const TiledRequest& b) {
    std::error_code ignored;
    return a.import == b.import && (a.path == b.path || std::filesystem::equivalent(a.path, b.path, ignored));
}

bool needs_overviews(const io::TiledFile& file) {
    if (!is_wide(TileTree(file.grid(), tile_patches, file.levels(), file.level_places()))) return false;
    std::error_code failed;
    if (file.overviews() == io::TiledFile::Overviews::outdated) return true;
    if (file.overviews() == io::TiledFile::Overviews::some)
        throw Error(fmt::format(
            "'{}' has too few overviews to be shown as a whole: 'talus tile' writes a file that has them",
            file.path().string()));
    const std::filesystem::path overviews = io::overviews_path(file.path());
    if (!file.why_no_overviews().empty())
        throw Error(
            fmt::format("no overviews are made beside '{}', as {}: 'talus tile' writes a file that has them",
                        file.path().string(), file.why_no_overviews()));
    if (std::filesystem::exists(overviews, failed))
        throw Error(fmt::format(
            "'{}' holds no overviews of '{}', remove it, or write a file that has them with 'talus tile'",
            overviews.string(), file.path().string()));
    return true;
}

TileTree tree_of(const io::TiledFile& file) {
    if (needs_overviews(file))
        throw Error(
            fmt::format("'{}' has no overviews to be shown as a whole: opening it makes them beside it",
                        file.path().string()));
    return TileTree(file.grid(), tile_patches, file.levels(), file.level_places());
}

glm::vec2 heights_of(const std::vector<TileBounds>& bounds) {
    glm::vec2 heights(bounds.front().lowest_m, bounds.front().highest_m);
    for (const TileBounds& one : bounds)
        heights = {std::min(heights.x, one.lowest_m), std::max(heights.y, one.highest_m)};
    return heights;
}

BeginProgress on_terminal() {
    return [](const std::string& what) -> Progress {
        const auto work = std::make_shared<LongWork>(what);
        return [work](double share) { return (*work)(share); };
    };
}

void make_overviews(const io::TiledFile& file, const BeginProgress& begin_progress) {
    const std::string path = file.path().string();
    const Progress told = begin_progress(fmt::format("making overviews of '{}'", path));
    // What is said while they are moved to their place counts too.
    if (!io::write_overviews(file, told) || !told(1))
        throw Interrupted(fmt::format("interrupted while overviews of '{}' were made", path));
}

TiledTerrain open_tiled(const TiledRequest& request, const BeginProgress& begin_progress) {
    io::TiledFile file(request.path, request.import);
    if (std::optional<TiledTerrain> ready = ready_of(file)) return std::move(*ready);
    if (needs_overviews(file)) {
        make_overviews(file, begin_progress);
        file = io::TiledFile(request.path, request.import);
    }
    TileTree tree = tree_of(file);
    std::vector<std::string> notes = file.notes();
    std::vector<TileBounds> bounds = measure_tile_bounds(
        tree, [&] { return file.make_reader(); },
        begin_progress(fmt::format("measuring the tiles of '{}'", request.path)));
    if (bounds.empty()) throw Interrupted(fmt::format("interrupted while '{}' was measured", request.path));
    try {
        io::write_tile_sidecar(file, tree, bounds);
    } catch (const Error& error) {
        notes.push_back(fmt::format("the bounds of its tiles are measured each time: {}", error.what()));
    }
    return with_bounds(std::move(file), std::move(tree), std::move(bounds), std::move(notes));
}

std::optional<TiledTerrain> ready_of(const io::TiledFile& file) {
    if (needs_overviews(file)) return std::nullopt;
    TileTree tree = tree_of(file);
    std::optional<std::vector<TileBounds>> bounds = io::read_tile_sidecar(file, tree);
    if (!bounds) return std::nullopt;
    return with_bounds(file, std::move(tree), std::move(*bounds), file.notes());
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
    return slots_within({"tiles.gpu_mib", gpu_mib, terrain.file.path()}, terrain.tree,
                        render::TiledSurface::bytes_of_slot(terrain.tree));
}

}  // namespace talus::app

#include "render/tiled/tiled_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "sim/error.h"

namespace talus::render {
namespace {

// As tile_node_texel() of shaders/render/tile_surface.glsl: each level has room for its rows below the one
// before.
int first_node_row(int rows, int level) {
    return 2 * rows - ((2 * rows) >> level) + level;
}

int node_rows(const TileTree& tree) {
    return first_node_row(tree.level(0).tiles.y, tree.top_level()) + tree.level(tree.top_level()).tiles.y;
}

int side_level(int side) {
    int level = 0;
    while (1 << level < side) ++level;
    return level;
}

// The slot of a node that lies in a tile that is drawn (shaders/maths/tile_cast.glsl).
constexpr float no_node = -2;

// Whole numbers that a float holds.
constexpr double exact_float = 1 << 24;

}  // namespace

TiledSurface::TiledSurface(TileTree tree, std::vector<TileBounds> bounds, int slots)
    : tree_(std::move(tree)),
      bounds_(std::move(bounds)),
      pool_(tree_, slots),
      slots_(static_cast<std::size_t>(pool_.slots())) {
    const glm::ivec2 finest = tree_.level(0).tiles;
    const int rows = node_rows(tree_);
    const glm::ivec2 coarsest = tree_.level(tree_.top_level()).tiles;
    if (pool_.slots() <= coarsest.x * coarsest.y)
        throw Error(fmt::format("{} slots are too few for the terrain's {} coarsest tiles and one more",
                                pool_.slots(), coarsest.x * coarsest.y));
    if (std::max(finest.x, rows) > gpu::widest_texture)
        throw Error(
            fmt::format("{} x {} tiles are more than the device's largest image holds", finest.x, finest.y));
    nodes_ = gpu::Texture("nodes of tiles", gpu::Format::rg32f, finest.x, rows);
    nodes_.fill(no_node);
    places_ = gpu::Texture("places in tiles", gpu::Format::rgba32f, 3, pool_.slots());
    highest_m_ = bounds_.front().highest_m;
    lowest_m_ = bounds_.front().lowest_m;
    for (const TileBounds& one : bounds_) {
        highest_m_ = std::max(highest_m_, one.highest_m);
        lowest_m_ = std::min(lowest_m_, one.lowest_m);
    }
}

std::size_t TiledSurface::bytes() const {
    return pool_.bytes() + bytes_of_nodes(tree_) +
           gpu::texel_bytes(gpu::Format::rgba32f) * static_cast<std::size_t>(places_.width()) *
               places_.height();
}

std::size_t TiledSurface::bytes_of_nodes(const TileTree& tree) {
    return gpu::texel_bytes(gpu::Format::rg32f) * static_cast<std::size_t>(tree.level(0).tiles.x) *
           static_cast<std::size_t>(node_rows(tree));
}

std::optional<TiledSurface::HeldTile> TiledSurface::finest_at(glm::dvec2 finest) const {
    const glm::dvec2 last(tree_.grid().nx - 1, tree_.grid().ny - 1);
    if (!glm::all(glm::greaterThanEqual(finest, glm::dvec2(0))) ||
        !glm::all(glm::lessThanEqual(finest, last)))
        return std::nullopt;
    const glm::ivec2 patch = glm::min(glm::ivec2(finest), glm::ivec2(last) - 1);
    for (int level = 0; level <= tree_.top_level(); ++level) {
        const glm::ivec2 place = patch / tree_.side() / (1 << level);
        const TileId tile{level, place.x, place.y};
        const int slot = slot_of(tile);
        if (slot >= 0) return HeldTile{tile, &pool_.heights(), pool_.heights_corner(slot)};
    }
    return std::nullopt;
}

int TiledSurface::slot_of(const TileId& tile) const {
    const auto found = slot_of_tile_.find(tree_.index_of(tile));
    return found == slot_of_tile_.end() ? -1 : found->second;
}

int TiledSurface::slot_to_fill() const {
    int best = -1;
    for (int slot = 0; slot < pool_.slots(); ++slot) {
        const Slot& one = slots_[static_cast<std::size_t>(slot)];
        if (one.tile.level < 0) return slot;
        if (one.tile.level == tree_.top_level()) continue;
        if (best < 0 || one.shown < slots_[static_cast<std::size_t>(best)].shown) best = slot;
    }
    return best;
}

void TiledSurface::put(const TileId& tile, std::span<const float> heights) {
    int slot = slot_of(tile);
    if (slot < 0) slot = slot_to_fill();
    Slot& filled = slots_[static_cast<std::size_t>(slot)];
    if (filled.tile.level >= 0) slot_of_tile_.erase(tree_.index_of(filled.tile));
    filled = {tile, 2 * looks_ + 1};
    slot_of_tile_[tree_.index_of(tile)] = slot;
    pool_.write(slot, tree_.samples_of(tile).count, heights);
}

void TiledSurface::put_aside(const TileId& tile, std::span<const float> heights) {
    const int slot = slot_to_fill();
    if (slot_of(tile) >= 0 || !is_spare(slots_[static_cast<std::size_t>(slot)])) return;
    put(tile, heights);
    // What the picture wants goes before it.
    slots_[static_cast<std::size_t>(slot)].shown = 2 * looks_ - 1;
}

bool TiledSurface::is_spare(const Slot& slot) const {
    return slot.tile.level < 0 || (slot.tile.level < tree_.top_level() && slot.shown + 1 < 2 * looks_);
}

void TiledSurface::clear() {
    for (Slot& slot : slots_) {
        if (slot.tile.level < 0 || slot.tile.level == tree_.top_level()) continue;
        slot_of_tile_.erase(tree_.index_of(slot.tile));
        slot.tile.level = -1;
    }
}

TileChoice TiledSurface::choose(const Camera& camera, glm::ivec2 size, double tolerance_px) const {
    const std::size_t coarsest = tree_.count() - tree_.first_of(tree_.top_level());
    const std::size_t room = static_cast<std::size_t>(pool_.slots()) - coarsest;
    return choose_tiles(tree_, bounds_, camera, size, tolerance_px, room,
                        [&](const TileId& tile) { return slot_of(tile); });
}

const TileChoice& TiledSurface::look(const Camera& camera, glm::ivec2 size, double tolerance_px) {
    ++looks_;
    choice_ = choose(camera, size, tolerance_px);
    // What stands for others is given away before what was asked for.
    const auto mark = [&](const std::vector<TileId>& tiles, std::uint64_t shown) {
        for (const TileId& tile : tiles) {
            const int slot = slot_of(tile);
            assert(slot >= 0 && "the coarsest tiles are put before the first look");
            slots_[static_cast<std::size_t>(slot)].shown = shown;
        }
    };
    mark(choice_.drawn, 2 * looks_);
    mark(choice_.needed, 2 * looks_ + 1);
    pool_.build();
    tell_nodes();
    tell_places(camera);
    return choice_;
}

std::vector<TileId> TiledSurface::look_ahead(const Camera& camera, glm::ivec2 size, double tolerance_px) {
    TileChoice later = choose(camera, size, tolerance_px);
    for (const TileId& tile : later.needed) {
        Slot& slot = slots_[static_cast<std::size_t>(slot_of(tile))];
        slot.shown = std::max(slot.shown, 2 * looks_ - 1);
    }
    const auto spare = static_cast<std::size_t>(
        std::count_if(slots_.begin(), slots_.end(), [&](const Slot& slot) { return is_spare(slot); }));
    later.wanted.resize(std::min(later.wanted.size(), spare));
    return std::move(later.wanted);
}

// Writes the nodes that changed since it was called last: a large terrain has many more.
void TiledSurface::tell_nodes() {
    NodeTexels now;
    for (const TileNode& node : choice_.nodes) now[tree_.index_of(node.tile)] = {node.highest_m, node.slot};
    NodeTexels changed;
    for (const auto& [index, texel] : told_nodes_)
        if (!now.contains(index)) changed[index] = glm::vec2(no_node);
    for (const auto& [index, texel] : now) {
        const auto told = told_nodes_.find(index);
        if (told == told_nodes_.end() || told->second != texel) changed[index] = texel;
    }
    told_nodes_ = std::move(now);
    std::vector<glm::vec2> run;
    for (auto one = changed.begin(); one != changed.end();) {
        const std::size_t first = one->first;
        const TileId tile = tree_.tile_at(first);
        const auto row_end = first + static_cast<std::size_t>(tree_.level(tile.level).tiles.x - tile.column);
        for (run.clear(); one != changed.end() && one->first == first + run.size() && one->first < row_end;
             ++one)
            run.push_back(one->second);
        const int row = first_node_row(tree_.level(0).tiles.y, tile.level) + tile.row;
        nodes_.write({tile.column, row, static_cast<int>(run.size()), 1}, std::as_bytes(std::span(run)));
    }
}

void TiledSurface::tell_places(const Camera& camera) {
    const Grid& grid = tree_.grid();
    const CastOrigin origin = cast_origin(grid, camera.eye);
    std::vector<glm::vec4> texels;
    texels.reserve(3 * slots_.size());
    for (const Slot& slot : slots_) {
        if (slot.tile.level < 0) {
            texels.resize(texels.size() + 3);
            continue;
        }
        // Among the finest samples the fraction is the one that exact rays have, to the bit.
        const glm::dvec2 place = tree_.place_in(slot.tile.level, glm::dvec2(origin.cell) + origin.fraction);
        glm::dvec2 cell = slot.tile.level == 0 ? glm::dvec2(origin.cell) : glm::floor(place);
        glm::dvec2 fraction = slot.tile.level == 0 ? origin.fraction : place - cell;
        cell -= glm::dvec2(tree_.first_level_patch(slot.tile));
        // An eye beyond what a float counts is at a fraction beyond 1.
        const glm::dvec2 counted = glm::clamp(cell, -exact_float, exact_float);
        fraction += cell - counted;
        cell = counted;
        const glm::dvec2 scale = 1.0 / tree_.level(slot.tile.level).ratio;
        texels.emplace_back(glm::dvec4(cell, fraction));
        texels.emplace_back(glm::dvec4(scale, slot.tile.level, pool_.column_and_row(slot_of(slot.tile))));
        const TileSamples held = tree_.samples_of(slot.tile);
        const glm::ivec2 first = glm::max(held.first, glm::ivec2(0));
        const glm::ivec2 last =
            glm::min(held.first + held.count - 2, tree_.level(slot.tile.level).samples - 2);
        const glm::ivec2 from = tree_.first_level_patch(slot.tile);
        texels.emplace_back(glm::vec2(first - from), glm::vec2(glm::max(first, last) - from));
    }
    places_.write(places_.whole(), std::as_bytes(std::span(texels)));
}

double TiledSurface::off_m(const Camera& camera, glm::ivec2 size) const {
    return choice_.tolerance_px * pixel_at_one_metre(camera, size.y);
}

void TiledSurface::bind(gpu::Program& program, const Camera& camera, glm::ivec2 size) const {
    set_camera(program, tree_.grid(), camera, size.x, size.y);
    pool_.bind(program);
    program.bind_sampled("tile_nodes", nodes_);
    program.bind_sampled("tile_places", places_);
    program.set("tile_side_level", side_level(tree_.side()));
    program.set("tile_top_level", tree_.top_level());
    program.set("top_level", tree_.top_level() + side_level(tree_.side()));
    program.set("tile_rows", tree_.level(0).tiles.y);
    program.set("tile_highest_m", highest_m_);
    program.set("tile_lowest_m", lowest_m_);
    program.set("tile_off_m", static_cast<float>(off_m(camera, size)));
}

}  // namespace talus::render

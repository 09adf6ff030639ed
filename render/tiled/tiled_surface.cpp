#include "render/tiled/tiled_surface.h"

#include <fmt/format.h>

#include <algorithm>
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
    : pool_(tree, slots), slots_(std::move(tree), std::move(bounds), pool_.slots()) {
    const glm::ivec2 finest = slots_.tree().level(0).tiles;
    const int rows = node_rows(slots_.tree());
    if (std::max(finest.x, rows) > gpu::widest_texture)
        throw Error(
            fmt::format("{} x {} tiles are more than the device's largest image holds", finest.x, finest.y));
    nodes_ = gpu::Texture("nodes of tiles", gpu::Format::rg32f, finest.x, rows);
    nodes_.fill(no_node);
    places_ = gpu::Texture("places in tiles", gpu::Format::rgba32f, 3, pool_.slots());
    highest_m_ = slots_.bounds().front().highest_m;
    lowest_m_ = slots_.bounds().front().lowest_m;
    for (const TileBounds& one : slots_.bounds()) {
        highest_m_ = std::max(highest_m_, one.highest_m);
        lowest_m_ = std::min(lowest_m_, one.lowest_m);
    }
}

std::size_t TiledSurface::bytes() const {
    return pool_.bytes() + bytes_of_nodes(tree()) +
           gpu::texel_bytes(gpu::Format::rgba32f) * static_cast<std::size_t>(places_.width()) *
               places_.height();
}

std::size_t TiledSurface::bytes_of_nodes(const TileTree& tree) {
    return gpu::texel_bytes(gpu::Format::rg32f) * static_cast<std::size_t>(tree.level(0).tiles.x) *
           static_cast<std::size_t>(node_rows(tree));
}

std::optional<TiledSurface::HeldTile> TiledSurface::finest_at(glm::dvec2 finest) const {
    const glm::dvec2 last(tree().grid().nx - 1, tree().grid().ny - 1);
    if (!glm::all(glm::greaterThanEqual(finest, glm::dvec2(0))) ||
        !glm::all(glm::lessThanEqual(finest, last)))
        return std::nullopt;
    const glm::ivec2 patch = glm::min(glm::ivec2(finest), glm::ivec2(last) - 1);
    for (int level = 0; level <= tree().top_level(); ++level) {
        const glm::ivec2 place = patch / tree().side() / (1 << level);
        const TileId tile{level, place.x, place.y};
        const int slot = slot_of(tile);
        if (slot >= 0) return HeldTile{tile, &pool_.heights(), pool_.heights_corner(slot)};
    }
    return std::nullopt;
}

void TiledSurface::put(const TileId& tile, std::span<const float> heights) {
    pool_.write(slots_.put(tile), tree().samples_of(tile).count, heights);
}

void TiledSurface::put_aside(const TileId& tile, std::span<const float> heights) {
    if (const std::optional<int> slot = slots_.put_aside(tile))
        pool_.write(*slot, tree().samples_of(tile).count, heights);
}

const TileChoice& TiledSurface::look(const Camera& camera, glm::ivec2 size, double tolerance_px) {
    const TileChoice& choice = slots_.look(camera, size, tolerance_px);
    pool_.build();
    tell_nodes();
    tell_places(camera);
    return choice;
}

// Writes the nodes that changed since it was called last: a large terrain has many more.
void TiledSurface::tell_nodes() {
    NodeTexels now;
    for (const TileNode& node : slots_.choice().nodes)
        now[tree().index_of(node.tile)] = {node.highest_m, node.slot};
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
        const TileId tile = tree().tile_at(first);
        const auto row_end = first + static_cast<std::size_t>(tree().level(tile.level).tiles.x - tile.column);
        for (run.clear(); one != changed.end() && one->first == first + run.size() && one->first < row_end;
             ++one)
            run.push_back(one->second);
        const int row = first_node_row(tree().level(0).tiles.y, tile.level) + tile.row;
        nodes_.write({tile.column, row, static_cast<int>(run.size()), 1}, std::as_bytes(std::span(run)));
    }
}

void TiledSurface::tell_places(const Camera& camera) {
    const Grid& grid = tree().grid();
    const CastOrigin origin = cast_origin(grid, camera.eye);
    std::vector<glm::vec4> texels;
    texels.reserve(3 * static_cast<std::size_t>(slots_.count()));
    for (int number = 0; number < slots_.count(); ++number) {
        const std::optional<TileId> held_tile = slots_.tile_in(number);
        if (!held_tile) {
            texels.resize(texels.size() + 3);
            continue;
        }
        const TileId& tile = *held_tile;
        // Among the finest samples the fraction is the one that exact rays have, to the bit.
        const glm::dvec2 place = tree().place_in(tile.level, glm::dvec2(origin.cell) + origin.fraction);
        glm::dvec2 cell = tile.level == 0 ? glm::dvec2(origin.cell) : glm::floor(place);
        glm::dvec2 fraction = tile.level == 0 ? origin.fraction : place - cell;
        cell -= glm::dvec2(tree().first_level_patch(tile));
        // An eye beyond what a float counts is at a fraction beyond 1.
        const glm::dvec2 counted = glm::clamp(cell, -exact_float, exact_float);
        fraction += cell - counted;
        cell = counted;
        const glm::dvec2 scale = 1.0 / tree().level(tile.level).ratio;
        texels.emplace_back(glm::dvec4(cell, fraction));
        texels.emplace_back(glm::dvec4(scale, tile.level, pool_.column_and_row(number)));
        const TileSamples held = tree().samples_of(tile);
        const glm::ivec2 first = glm::max(held.first, glm::ivec2(0));
        const glm::ivec2 last = glm::min(held.first + held.count - 2, tree().level(tile.level).samples - 2);
        const glm::ivec2 from = tree().first_level_patch(tile);
        texels.emplace_back(glm::vec2(first - from), glm::vec2(glm::max(first, last) - from));
    }
    places_.write(places_.whole(), std::as_bytes(std::span(texels)));
}

double TiledSurface::off_m(const Camera& camera, glm::ivec2 size) const {
    return slots_.choice().tolerance_px * pixel_at_one_metre(camera, size.y);
}

void TiledSurface::bind(gpu::Program& program, const Camera& camera, glm::ivec2 size) const {
    set_camera(program, tree().grid(), camera, size.x, size.y);
    pool_.bind(program);
    program.bind_sampled("tile_nodes", nodes_);
    program.bind_sampled("tile_places", places_);
    program.set("tile_side_level", side_level(tree().side()));
    program.set("tile_top_level", tree().top_level());
    program.set("top_level", tree().top_level() + side_level(tree().side()));
    program.set("tile_rows", tree().level(0).tiles.y);
    program.set("tile_highest_m", highest_m_);
    program.set("tile_lowest_m", lowest_m_);
    program.set("tile_off_m", static_cast<float>(off_m(camera, size)));
}

}  // namespace talus::render

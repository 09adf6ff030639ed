#include "render/tiled/tiled_surface.h"

#include <algorithm>
#include <cmath>

namespace talus::render {
namespace {

// Whole numbers that a float holds.
constexpr double exact_float = 1 << 24;

// Of what shaders are told of a slot.
constexpr int place_texels = 3;

}  // namespace

TiledSurface::TiledSurface(TileTree tree, std::vector<TileBounds> bounds, int slots)
    : pool_(tree, slots), slots_(std::move(tree), std::move(bounds), pool_.slots()), nodes_(slots_.tree()) {
    places_ = gpu::Texture("places in tiles", gpu::Format::rgba32f, place_texels, pool_.slots());
    highest_m_ = slots_.bounds().front().highest_m;
    lowest_m_ = slots_.bounds().front().lowest_m;
    for (const TileBounds& one : slots_.bounds()) {
        highest_m_ = std::max(highest_m_, one.highest_m);
        lowest_m_ = std::min(lowest_m_, one.lowest_m);
    }
}

std::size_t TiledSurface::bytes() const {
    return pool_.bytes() + TileNodes::bytes_of(tree()) +
           gpu::texel_bytes(gpu::Format::rgba32f) * static_cast<std::size_t>(places_.width()) *
               places_.height();
}

std::size_t TiledSurface::bytes_of_slot(const TileTree& tree) {
    return TilePool::bytes_of_slot(tree) + place_texels * gpu::texel_bytes(gpu::Format::rgba32f);
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
    nodes_.tell(tree(), choice.nodes);
    tell_places(camera);
    return choice;
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

void TiledSurface::bind(gpu::Program& program, const Camera& camera, glm::ivec2 size) const {
    set_camera(program, tree().grid(), camera, size.x, size.y);
    pool_.bind(program);
    program.bind_sampled("tile_nodes", nodes_.texture());
    program.bind_sampled("tile_places", places_);
    program.set("tile_side_level", tree().side_level());
    program.set("tile_top_level", tree().top_level());
    program.set("top_level", tree().top_level() + tree().side_level());
    program.set("tile_rows", tree().level(0).tiles.y);
    program.set("tile_highest_m", highest_m_);
    program.set("tile_lowest_m", lowest_m_);
    program.set("tile_off_px", static_cast<float>(off_px()));
}

}  // namespace talus::render

#include "sim/tiled/tile_tree.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "sim/error.h"

namespace talus {

TileTree::TileTree(const Grid& grid, int side, const std::vector<glm::ivec2>& level_samples,
                   LevelPlaces places)
    : grid_(grid), side_(side), room_patches_(0), first_of_level_{0} {
    if (side < 16 || (side & (side - 1)) != 0)
        throw Error("a tile has " + std::to_string(side) +
                    " patches a side, a power of two from 16 on is needed");
    if (level_samples.empty() || level_samples.front() != glm::ivec2(grid.nx, grid.ny) || grid.nx < 2 ||
        grid.ny < 2)
        throw Error("the finest level of a tiled terrain must have the terrain's samples, at least 2 x 2");
    const glm::ivec2 patches(grid.nx - 1, grid.ny - 1);
    for (const glm::ivec2 samples : level_samples) {
        const int across = side << levels_.size();
        const glm::dvec2 ratio = places == LevelPlaces::by_halves
                                     ? glm::dvec2(std::ldexp(1.0, static_cast<int>(levels_.size())))
                                     : glm::dvec2(grid.nx, grid.ny) / glm::dvec2(samples);
        const TileLevel level = {samples, ratio, (patches + across - 1) / across};
        levels_.push_back(level);
        first_of_level_.push_back(first_of_level_.back() +
                                  static_cast<std::size_t>(level.tiles.x) * level.tiles.y);
        // Where both edges fall between samples there is a patch more, and one lies behind.
        const glm::dvec2 widest = glm::min(glm::dvec2(across), glm::dvec2(patches)) / level.ratio;
        room_patches_ =
            std::max(room_patches_, static_cast<int>(std::ceil(std::max(widest.x, widest.y))) + 2);
        if (level.tiles.x * level.tiles.y == 1) break;
    }
    room_patches_ = (room_patches_ + 15) / 16 * 16;
}

glm::dvec2 TileTree::place_in(int number, glm::dvec2 finest) const {
    return (finest + 0.5) / level(number).ratio - 0.5;
}

glm::ivec2 TileTree::first_patch(const TileId& tile) const {
    return glm::ivec2(tile.column, tile.row) * (side_ << tile.level);
}

glm::ivec2 TileTree::last_patch(const TileId& tile) const {
    return glm::min(glm::ivec2(tile.column + 1, tile.row + 1) * (side_ << tile.level),
                    glm::ivec2(grid_.nx - 1, grid_.ny - 1));
}

glm::ivec2 TileTree::first_level_patch(const TileId& tile) const {
    return glm::floor(place_in(tile.level, first_patch(tile)));
}

TileSamples TileTree::samples_of(const TileId& tile) const {
    const glm::ivec2 first = first_level_patch(tile);
    const glm::ivec2 last = glm::ceil(place_in(tile.level, last_patch(tile)));
    return {first - 1, last - first + 3};
}

std::size_t TileTree::index_of(const TileId& tile) const {
    return first_of(tile.level) + static_cast<std::size_t>(tile.row) * level(tile.level).tiles.x +
           tile.column;
}

std::vector<TileId> TileTree::coarsest_tiles() const {
    std::vector<TileId> tiles;
    for (std::size_t index = first_of(top_level()); index < count(); ++index) tiles.push_back(tile_at(index));
    return tiles;
}

TileId TileTree::tile_at(std::size_t index) const {
    TileId tile;
    while (index >= first_of(tile.level + 1)) ++tile.level;
    const auto within = static_cast<int>(index - first_of(tile.level));
    const int columns = level(tile.level).tiles.x;
    return {tile.level, within % columns, within / columns};
}

std::vector<glm::ivec2> halved_levels(glm::ivec2 samples) {
    std::vector<glm::ivec2> levels = {samples};
    while (samples != glm::ivec2(1)) {
        samples = (samples + 1) / 2;
        levels.push_back(samples);
    }
    return levels;
}

}  // namespace talus

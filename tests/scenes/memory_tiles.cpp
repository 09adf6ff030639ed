#include "tests/scenes/memory_tiles.h"

#include <algorithm>
#include <cmath>

namespace talus::scenes {

MemoryTiles::MemoryTiles(const Grid& grid, std::vector<float> heights, int side)
    : tree_(grid, side, halved_levels({grid.nx, grid.ny}), LevelPlaces::by_halves) {
    levels_.push_back(std::move(heights));
    for (int level = 1; level <= tree_.top_level(); ++level) {
        const glm::ivec2 size = tree_.level(level).samples;
        const glm::ivec2 finer = tree_.level(level - 1).samples;
        const std::vector<float>& from = levels_.back();
        std::vector<float> to;
        for (int row = 0; row < size.y; ++row)
            for (int column = 0; column < size.x; ++column) {
                double sum = 0;
                int count = 0;
                for (int i = 0; i < 4; ++i) {
                    const glm::ivec2 at(2 * column + i % 2, 2 * row + i / 2);
                    if (at.x >= finer.x || at.y >= finer.y) continue;
                    sum += from[static_cast<std::size_t>(at.y) * finer.x + at.x];
                    ++count;
                }
                to.push_back(static_cast<float>(sum / count));
            }
        levels_.push_back(std::move(to));
    }
    bounds_ = measure_tile_bounds(tree_, [this] {
        return [this](int level, const TileSamples& samples, std::vector<float>& read_heights) {
            read(level, samples, read_heights);
        };
    });
}

void MemoryTiles::read(int level, const TileSamples& samples, std::vector<float>& heights) const {
    const glm::ivec2 size = tree_.level(level).samples;
    const std::vector<float>& from = levels_[static_cast<std::size_t>(level)];
    heights.clear();
    for (int row = 0; row < samples.count.y; ++row)
        for (int column = 0; column < samples.count.x; ++column) {
            const glm::ivec2 at =
                glm::clamp(samples.first + glm::ivec2(column, row), glm::ivec2(0), size - 1);
            heights.push_back(from[static_cast<std::size_t>(at.y) * size.x + at.x]);
        }
}

std::vector<float> MemoryTiles::read(const TileId& tile) const {
    std::vector<float> heights;
    read(tile.level, tree_.samples_of(tile), heights);
    return heights;
}

double MemoryTiles::height_at(int level, glm::dvec2 finest) const {
    const glm::dvec2 place = tree_.place_in(level, finest);
    const glm::ivec2 cell = glm::floor(place);
    const glm::dvec2 share = place - glm::dvec2(cell);
    std::vector<float> z;
    read(level, {cell, {2, 2}}, z);
    return (1 - share.y) * ((1 - share.x) * z[0] + share.x * z[1]) +
           share.y * ((1 - share.x) * z[2] + share.x * z[3]);
}

}  // namespace talus::scenes

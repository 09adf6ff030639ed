#include "app/core/tile_sketch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "sim/tiled/sparse_sampling.h"
#include "sim/tiled/void_filling.h"

namespace talus::app {
namespace {

// Reading a sparse sampling may take so long.
constexpr double sampling_s = 0.5;

// Heights of the coarsest level of a tree.
struct CoarseHeights {
    TileTree tree;
    std::vector<float> heights;
    glm::ivec2 size() const { return tree.level(tree.top_level()).samples; }
};

// Samples of any level, between those of the coarsest.
ReadSamples reader_of(const std::shared_ptr<const CoarseHeights>& coarse) {
    return [coarse](int level, const TileSamples& samples, std::vector<float>& heights) {
        const TileTree& tree = coarse->tree;
        const glm::ivec2 last = tree.level(level).samples - 1;
        heights.assign(static_cast<std::size_t>(samples.count.x) * samples.count.y,
                       std::numeric_limits<float>::quiet_NaN());
        fill_voids_from(coarse->heights, coarse->size(), heights, samples.count, [&](glm::ivec2 sample) {
            const glm::dvec2 here(glm::clamp(samples.first + sample, glm::ivec2(0), last));
            const glm::dvec2 finest = (here + 0.5) * tree.level(level).ratio - 0.5;
            return tree.place_in(tree.top_level(), finest);
        });
    };
}

// Of neighbours in a row, m.
float mean_step(const std::vector<float>& heights, glm::ivec2 size) {
    double sum = 0;
    double count = 0;
    for (int y = 0; y < size.y; ++y)
        for (int x = 1; x < size.x; ++x, ++count) {
            const float* const here = heights.data() + static_cast<std::size_t>(y) * size.x + x;
            sum += std::abs(here[0] - here[-1]);
        }
    return static_cast<float>(sum / std::max(count, 1.0));
}

// The levels that the file has, with bounds that terrain mostly keeps: peaks that means have lost rise over
// them by no more than half the relief that the means have, and a level's surface is as far off as its
// samples lie from each other, which halves with their spacing.
TiledTerrain sketch_of_levels(io::TiledFile file, TileTree tree) {
    const glm::ivec2 size = tree.level(tree.top_level()).samples;
    std::vector<float> heights;
    file.make_reader()(tree.top_level(), {glm::ivec2(0), size}, heights);
    const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
    const float margin_m = std::max((*high - *low) / 2, 1.0F);
    const float step_m = mean_step(heights, size);
    std::vector<TileBounds> bounds(tree.count());
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        const int level = tree.tile_at(i).level;
        const float error_m = level == 0 ? 0 : std::ldexp(step_m, level - tree.top_level());
        bounds[i] = {*low - margin_m, *high + margin_m, error_m};
    }
    std::vector<std::string> notes = file.notes();
    TiledTerrain terrain{std::move(file), std::move(tree), std::move(bounds), std::move(notes)};
    terrain.lowest_m = *low;
    terrain.highest_m = *high;
    terrain.is_measured = false;
    return terrain;
}

TiledTerrain sketch_of_samples(io::TiledFile file) {
    const Grid& grid = file.grid();
    const glm::ivec2 samples(grid.nx, grid.ny);
    CoarseHeights coarse{TileTree(grid, tile_patches, halved_levels(samples), LevelPlaces::by_halves), {}};
    coarse.heights = sample_sparsely(samples, coarse.size(), file.source().make_reader, sampling_s);
    std::vector<std::string> notes = file.notes();
    if (coarse.heights.empty()) {
        notes.push_back(fmt::format("no height of '{}' was found at once: the sketch of it is flat",
                                    file.path().string()));
        coarse.heights.assign(static_cast<std::size_t>(coarse.size().x) * coarse.size().y, 0.0F);
    }
    const auto [low, high] = std::minmax_element(coarse.heights.begin(), coarse.heights.end());
    const TileBounds all{*low, *high, 0};
    TiledTerrain terrain{std::move(file), coarse.tree, std::vector(coarse.tree.count(), all),
                         std::move(notes)};
    terrain.lowest_m = *low;
    terrain.highest_m = *high;
    terrain.is_measured = false;
    terrain.instead = reader_of(std::make_shared<const CoarseHeights>(std::move(coarse)));
    return terrain;
}

}  // namespace

TiledTerrain sketch_of(io::TiledFile file) {
    if (needs_overviews(file)) return sketch_of_samples(std::move(file));
    TileTree tree = tree_of(file);
    return sketch_of_levels(std::move(file), std::move(tree));
}

}  // namespace talus::app

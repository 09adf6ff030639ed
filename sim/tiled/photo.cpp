#include "sim/tiled/photo.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/tiled/screen_colour.h"

namespace talus {
namespace {

// Texels of the finest level in a row of a tile.
constexpr int photo_side = 256;

PhotoTexel mean_of(const PhotoTexel& a, const PhotoTexel& b, const PhotoTexel& c, const PhotoTexel& d) {
    const auto mean = [](std::uint8_t p, std::uint8_t q, std::uint8_t r, std::uint8_t s) {
        return to_screen(0.25F * ((from_screen(p) + from_screen(q)) + (from_screen(r) + from_screen(s))));
    };
    return {mean(a.r, b.r, c.r, d.r), mean(a.g, b.g, c.g, d.g), mean(a.b, b.b, c.b, d.b),
            static_cast<std::uint8_t>((a.a + b.a + c.a + d.a + 2) / 4)};
}

}  // namespace

TileTree photo_tree(glm::ivec2 texels, const Grid& ground, const PhotoPlace& place) {
    const Grid grid{texels.x, texels.y, ground.dx / place.scale.x, ground.dy / place.scale.y};
    return TileTree(grid, photo_side, halved_levels(texels));
}

std::vector<TileBounds> photo_bounds(const TileTree& tree, const PhotoPlace& place,
                                     const HeightsBetween& heights) {
    std::vector<TileBounds> bounds(tree.count());
    for (std::size_t i = 0; i < tree.count(); ++i) {
        const TileId tile = tree.tile_at(i);
        const TileLevel& level = tree.level(tile.level);
        const glm::dvec2 texel_m = level.ratio * glm::dvec2(tree.grid().dx, tree.grid().dy);
        const auto error_m = static_cast<float>(std::max(texel_m.x, texel_m.y));
        if (tile.level == 0) {
            const auto range = heights((glm::dvec2(tree.first_patch(tile)) - place.first) / place.scale,
                                       (glm::dvec2(tree.last_patch(tile)) - place.first) / place.scale);
            if (range) bounds[i] = {range->x, range->y, error_m};
            continue;
        }
        for (int k = 0; k < 4; ++k) {
            const TileId below = {tile.level - 1, 2 * tile.column + k % 2, 2 * tile.row + k / 2};
            const glm::ivec2 tiles = tree.level(below.level).tiles;
            if (below.column >= tiles.x || below.row >= tiles.y) continue;
            const TileBounds& one = bounds[tree.index_of(below)];
            if (one.error_m <= 0) continue;
            const bool is_first = bounds[i].error_m <= 0;
            bounds[i] = {is_first ? one.lowest_m : std::min(bounds[i].lowest_m, one.lowest_m),
                         is_first ? one.highest_m : std::max(bounds[i].highest_m, one.highest_m), error_m};
        }
    }
    return bounds;
}

ReadTexels with_smaller_pictures(ReadTexels read, int halvings) {
    return [read = std::move(read), halvings](int level, const TileSamples& samples,
                                              std::vector<PhotoTexel>& texels) {
        read(level, samples, texels);
        glm::ivec2 size = samples.count;
        std::size_t from = 0;
        for (int i = 0; i < halvings; ++i) {
            const std::size_t before = texels.size();
            texels.resize(before + static_cast<std::size_t>(size.x / 2) * (size.y / 2));
            std::size_t to = before;
            for (int y = 0; y + 1 < size.y; y += 2) {
                const PhotoTexel* upper = texels.data() + from + static_cast<std::size_t>(y) * size.x;
                const PhotoTexel* lower = upper + size.x;
                for (int x = 0; x + 1 < size.x; x += 2)
                    texels[to++] = mean_of(upper[x], upper[x + 1], lower[x], lower[x + 1]);
            }
            from = before;
            size /= 2;
        }
    };
}

}  // namespace talus

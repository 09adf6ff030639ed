#include "sim/tiled/heights_between.h"

#include <algorithm>
#include <utility>

namespace talus {
namespace {

// The patches between them that a ground has; none.
struct Patches {
    glm::ivec2 first;
    glm::ivec2 last;
};
std::optional<Patches> patches_between(const Grid& grid, glm::dvec2 first, glm::dvec2 last) {
    const glm::dvec2 end(grid.nx - 1, grid.ny - 1);
    if (glm::any(glm::greaterThan(first, end)) || glm::any(glm::lessThan(last, glm::dvec2(0))))
        return std::nullopt;
    const glm::ivec2 most(grid.nx - 2, grid.ny - 2);
    return Patches{
        glm::clamp(glm::ivec2(glm::floor(glm::clamp(first, glm::dvec2(0), end))), glm::ivec2(0), most),
        glm::clamp(glm::ivec2(glm::floor(glm::clamp(last, glm::dvec2(0), end))), glm::ivec2(0), most)};
}

glm::vec2 wider(glm::vec2 a, glm::vec2 b) {
    return {std::min(a.x, b.x), std::max(a.y, b.y)};
}

}  // namespace

HeightsBetween heights_between(const Grid& grid, std::vector<float> heights) {
    return [grid, heights = std::move(heights)](glm::dvec2 first,
                                                glm::dvec2 last) -> std::optional<glm::vec2> {
        const std::optional<Patches> patches = patches_between(grid, first, last);
        if (!patches) return std::nullopt;
        const auto row = [&](int y) { return heights.begin() + static_cast<std::ptrdiff_t>(y) * grid.nx; };
        glm::vec2 range(row(patches->first.y)[patches->first.x]);
        for (int y = patches->first.y; y <= patches->last.y + 1; ++y) {
            const auto [low, high] =
                std::minmax_element(row(y) + patches->first.x, row(y) + patches->last.x + 2);
            range = wider(range, {*low, *high});
        }
        return range;
    };
}

HeightsBetween heights_between(const TileTree& tree, std::vector<TileBounds> bounds) {
    return [tree, bounds = std::move(bounds)](glm::dvec2 first, glm::dvec2 last) -> std::optional<glm::vec2> {
        const std::optional<Patches> patches = patches_between(tree.grid(), first, last);
        if (!patches) return std::nullopt;
        // Of the level at which they are few.
        const glm::ivec2 across = patches->last - patches->first + 1;
        int level = 0;
        while (level < tree.top_level() && tree.side() << level < std::max(across.x, across.y)) ++level;
        const glm::ivec2 from = patches->first / (tree.side() << level);
        const glm::ivec2 to = patches->last / (tree.side() << level);
        std::optional<glm::vec2> range;
        for (int row = from.y; row <= to.y; ++row)
            for (int column = from.x; column <= to.x; ++column) {
                const TileBounds& one = bounds[tree.index_of({level, column, row})];
                const glm::vec2 its(one.lowest_m - one.error_m, one.highest_m + one.error_m);
                range = range ? wider(*range, its) : its;
            }
        return range;
    };
}

}  // namespace talus

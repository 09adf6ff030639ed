#include "sim/terrain/sea.h"

#include <vector>

#include "sim/terrain/bed_beyond.h"

namespace talus {

double fill_sea(TerrainState& state, double level_m) {
    const Grid& grid = state.grid;
    const std::vector<float> ground = state.ground();
    if (state.water.empty()) state.water.assign(grid.count(), glm::vec4(0));
    std::vector<bool> reached(grid.count(), false);
    std::vector<glm::ivec2> open;
    const auto visit = [&](int column, int row) {
        if (column < 0 || row < 0 || column >= grid.nx || row >= grid.ny) return;
        const std::size_t at = static_cast<std::size_t>(row) * grid.nx + column;
        if (reached[at] || ground[at] >= level_m) return;
        reached[at] = true;
        open.emplace_back(column, row);
    };
    // Where the ground beyond an edge is known, the sea comes in where that lies below it.
    const BedAt bed = state.bed_beyond.empty() ? BedAt() : bed_around(state);
    const auto enter = [&](int column, int row, glm::ivec2 outward) {
        if (!bed || bed(glm::ivec2(column, row) + outward) < level_m) visit(column, row);
    };
    for (int column = 0; column < grid.nx; ++column) {
        enter(column, 0, {0, -1});
        enter(column, grid.ny - 1, {0, 1});
    }
    for (int row = 0; row < grid.ny; ++row) {
        enter(0, row, {-1, 0});
        enter(grid.nx - 1, row, {1, 0});
    }
    double gained_m = 0;
    while (!open.empty()) {
        const glm::ivec2 sample = open.back();
        open.pop_back();
        const std::size_t at = static_cast<std::size_t>(sample.y) * grid.nx + sample.x;
        glm::vec4& water = state.water[at];
        const double before = static_cast<double>(water.x) + water.y;
        const auto depth = static_cast<float>(level_m - ground[at]);
        if (depth > before) {
            gained_m += depth - before;
            water.x = depth;
            water.y = 0;
        }
        visit(sample.x - 1, sample.y);
        visit(sample.x + 1, sample.y);
        visit(sample.x, sample.y - 1);
        visit(sample.x, sample.y + 1);
    }
    return gained_m * grid.dx * grid.dy;
}

}  // namespace talus

// The double twin of the caster, which is the reference of all methods, against brute force.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "render/cast_twin.h"

namespace talus::cast_test {
namespace {

// Every patch along the ray, the smallest root of a fine march and
// bisection.
TEST(CastTwin, FindsTheFirstCrossingThatAMarchFinds) {
    const Grid grid{17, 12, 2, 3};
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<float> heights(grid.count());
    for (float& h : heights) h = static_cast<float>(8 * unit(random));
    maths::CastTwin<double> twin(grid, heights);
    const auto surface = [&](double column, double row) {
        const int i = std::clamp(static_cast<int>(std::floor(column)), 0, grid.nx - 2);
        const int j = std::clamp(static_cast<int>(std::floor(row)), 0, grid.ny - 2);
        const auto at = [&](int x, int y) {
            return static_cast<double>(heights[static_cast<std::size_t>(y) * grid.nx + x]);
        };
        const double u = column - i;
        const double v = row - j;
        return (1 - v) * ((1 - u) * at(i, j) + u * at(i + 1, j)) +
               v * ((1 - u) * at(i, j + 1) + u * at(i + 1, j + 1));
    };
    int hits = 0;
    for (int ray = 0; ray < 4000; ++ray) {
        const glm::dvec3 eye(grid.width_m() * (2 * unit(random) - 0.5),
                             grid.height_m() * (2 * unit(random) - 0.5), 12 * unit(random));
        const glm::dvec3 aim(grid.width_m() * unit(random), grid.height_m() * unit(random), 8 * unit(random));
        twin.look(grid, {eye, aim, 40}, 1, 1);
        const glm::dvec3 direction = glm::normalize(aim - eye);
        const double found = twin.cast_pixel(0, 0).distance_m;
        const double step = 0.003;
        double marched = -1;
        double clearance = 1e9;
        for (int k = 0; k < 40000; ++k) {
            const glm::dvec3 p = eye + direction * (step * k);
            const double column = grid.column_of(p.x);
            const double row = grid.row_of(p.y);
            if (column < 0 || row < 0 || column > grid.nx - 1 || row > grid.ny - 1) continue;
            const double above = p.z - surface(column, row);
            if (above <= 0) {
                marched = step * k;
                break;
            }
            clearance = std::min(clearance, above);
        }
        if (marched < 0 && clearance < 0.02) continue;  // the march itself cannot tell
        if (marched >= 0 && found >= 0 && found < marched - 1.5 * step) {
            // A graze shorter than a march step: the found place must lie on the surface.
            const glm::dvec3 p = eye + direction * found;
            EXPECT_NEAR(p.z, surface(grid.column_of(p.x), grid.row_of(p.y)), 1e-9);
            continue;
        }
        ASSERT_NEAR(found, marched, marched < 0 ? 1e-9 : 1.5 * step) << "ray " << ray;
        hits += found >= 0 ? 1 : 0;
    }
    EXPECT_GT(hits, 1000);
}

}  // namespace
}  // namespace talus::cast_test

// A column of loose ground collapses into the exact cone (docs/numerics.md, "Thermal erosion").
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "sim/gpu/context.h"
#include "sim/ledger.h"
#include "sim/passes/thermal.h"

namespace talus {
namespace {

TEST(Column, CollapsesIntoTheConeOfItsAngleOfRepose) {
    const gpu::Context context;
    const int n = 257;
    const Grid grid{n, n, 1, 1};
    const double slope = std::tan(33 * std::numbers::pi / 180);
    const double column_radius = 22;
    const double column_height = 120;
    std::vector<float> heights(grid.count(), 0.0F);
    double volume = 0;
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x)
            if (std::hypot(x - 128, y - 128) <= column_radius) {
                heights[static_cast<std::size_t>(y) * n + x] = static_cast<float>(column_height);
                volume += column_height;
            }
    // V = pi R^2 H / 3 with H = R S.
    const double radius = std::cbrt(3 * volume / (std::numbers::pi * slope));
    const double peak = radius * slope;
    Terrain terrain(bedrock_terrain(grid, heights));
    Thermal thermal(terrain);
    Ledger ledger(terrain);
    const LedgerStart begin = ledger.begin(terrain, {});
    const Brush brush(terrain);
    const ThermalSettings settings{33, 0.25};
    const ThermalStep step = thermal_step(grid, settings, 1, 1);
    ASSERT_EQ(thermal_substeps(grid, settings, 1), 1);
    const int ticks = static_cast<int>(2 * radius * radius);
    for (int i = 0; i < ticks; ++i) thermal.substep(terrain, step);

    const std::vector<float> ground = terrain.ground.read_all<float>();
    const auto at = [&](int x, int y) {
        return static_cast<double>(ground[static_cast<std::size_t>(y) * n + x]);
    };
    double steepest = 0;
    for (int y = 1; y < n - 1; ++y)
        for (int x = 1; x < n - 1; ++x)
            steepest = std::max(
                steepest, std::hypot((at(x + 1, y) - at(x - 1, y)) / 2, (at(x, y + 1) - at(x, y - 1)) / 2));
    // Radius of the contour at a quarter of the peak, along a direction, by linear interpolation.
    const auto contour = [&](double dx, double dy) {
        const double level = peak / 4;
        for (int i = 0; i < 120; ++i) {
            const double a = at(128 + static_cast<int>(i * dx), 128 + static_cast<int>(i * dy));
            const double b = at(128 + static_cast<int>((i + 1) * dx), 128 + static_cast<int>((i + 1) * dy));
            if (a >= level && b < level) return (i + (a - level) / (a - b)) * std::hypot(dx, dy);
        }
        return 0.0;
    };
    const double axis = contour(1, 0);
    const double diagonal = contour(1, 1);
    const double angle = std::atan(steepest) * 180 / std::numbers::pi;
    const LedgerReading books =
        ledger.reading(begin, (ledger.sum(terrain), ledger.tile_sums().read_all<glm::dvec4>()), {},
                       brush.books, {}, glm::dvec2(0), 0);
    std::printf(
        "column: %d ticks, steepest %.2f degrees, radii %.3f (axis) %.3f (diagonal) of %.3f, peak %.3f of "
        "%.3f, ledger %.2g of moved\n",
        ticks, angle, axis, diagonal, 0.75 * radius, at(128, 128), peak, books.closing_error_of_moved());
    EXPECT_LE(angle, 34.5);
    EXPECT_NEAR(diagonal / axis, 1, 0.01);
    EXPECT_NEAR(axis / (0.75 * radius), 1, 0.01);
    EXPECT_NEAR(diagonal / (0.75 * radius), 1, 0.01);
    EXPECT_NEAR(at(128, 128) / peak, 1, 0.005);
    EXPECT_LE(books.closing_error_of_moved(), 1e-6);
}

}  // namespace
}  // namespace talus

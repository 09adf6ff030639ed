// A column of loose ground collapses into the exact cone (docs/numerics.md, "Thermal erosion").
#include <gtest/gtest.h>

#include <cstdio>

#include "app/claims/exact_solutions.h"
#include "sim/gpu/context.h"
#include "sim/passes/thermal.h"

namespace talus::column_test {
namespace {

TEST(Column, CollapsesIntoTheConeOfItsAngleOfRepose) {
    const gpu::Context context;
    ASSERT_EQ(thermal_substeps({257, 257, 1, 1}, {33, 0.25}, 1), 1);
    const claims::ConeError cone = claims::collapsed_column(257, 22, 120);
    std::printf(
        "column: %d ticks, steepest %.2f degrees, radii %.3f (axis) %.3f (diagonal) of %.3f, peak %.3f of "
        "%.3f, ledger %.2g of moved\n",
        cone.ticks, cone.steepest_deg, cone.axis_m, cone.diagonal_m, cone.exact_m, cone.peak_m,
        cone.exact_peak_m, cone.ledger_of_moved);
    EXPECT_LE(cone.steepest_deg, 34.5);
    EXPECT_NEAR(cone.diagonal_m / cone.axis_m, 1, 0.01);
    EXPECT_NEAR(cone.axis_m / cone.exact_m, 1, 0.01);
    EXPECT_NEAR(cone.diagonal_m / cone.exact_m, 1, 0.01);
    EXPECT_NEAR(cone.peak_m / cone.exact_peak_m, 1, 0.005);
    EXPECT_LE(cone.ledger_of_moved, 1e-6);
}

// Olsen's schemes lose nothing and come to rest at the angle along the axes. But their cones know the grid:
// the threshold is one of height, so that slopes along the diagonals are flatter, and reach farther.
TEST(Column, OfOlsenDependsOnTheGrid) {
    const gpu::Context context;
    for (const ThermalScheme scheme : {ThermalScheme::olsen, ThermalScheme::olsen_fast}) {
        const claims::ConeError cone = claims::collapsed_column(129, 11, 60, scheme);
        std::printf(
            "%s: steepest %.2f degrees, radii %.3f (axis) %.3f (diagonal) of %.3f, ledger %.2g of moved\n",
            scheme == ThermalScheme::olsen ? "olsen" : "olsen_fast", cone.steepest_deg, cone.axis_m,
            cone.diagonal_m, cone.exact_m, cone.ledger_of_moved);
        EXPECT_LE(cone.steepest_deg, 34.5);
        EXPECT_GT(cone.diagonal_m / cone.axis_m, 1.1);
        EXPECT_LE(cone.ledger_of_moved, 1e-6);
    }
}

}  // namespace
}  // namespace talus::column_test

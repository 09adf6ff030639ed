// Masks out of the terrain, blurs, and what they limit.
#include <gtest/gtest.h>

#include <cmath>

#include "sim/gpu/context.h"
#include "sim/simulation.h"
#include "sim/simulation_parameters.h"

namespace talus {
namespace {

constexpr std::size_t undo_bytes = std::size_t{1} << 28U;

// Level in the west, a slope of 1 to 2 eastwards from the middle on.
TerrainState bend(int n) {
    const Grid grid{n, n, 10, 10};
    std::vector<float> heights;
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) heights.push_back(100 + 5.0F * std::max(0, x - n / 2));
    return bedrock_terrain(grid, heights);
}

float mask_at(const TerrainState& state, int x, int y) {
    return state.painted.empty() ? 0 : state.painted[static_cast<std::size_t>(y) * state.grid.nx + x].y;
}

TEST(Mask, FollowsSlopeHeightCurvatureAndDepth) {
    const gpu::Context context;
    TerrainState state = bend(81);
    state.water.assign(state.grid.count(), glm::vec4(0));
    state.water[40 * 81 + 7] = {2, 0, 0, 0};
    Simulation simulation(state, Parameters(simulation_parameters()), undo_bytes);
    const double steep = std::atan(0.5) * 180 / 3.14159265358979;
    simulation.apply(MakeMask{MaskSource::slope, steep - 1, 90});
    TerrainState made = simulation.read();
    EXPECT_EQ(mask_at(made, 20, 30), 0);
    EXPECT_EQ(mask_at(made, 60, 30), 1);
    simulation.apply(MakeMask{MaskSource::height, 100, 200, 100});
    made = simulation.read();
    EXPECT_EQ(mask_at(made, 5, 5), 1);
    EXPECT_EQ(mask_at(made, 60, 5), 1) << "200 m, at the upper end";
    EXPECT_NEAR(mask_at(made, 70, 5), 0.5, 1e-5) << "250 m, half way down a fade of 100 m";
    simulation.apply(MakeMask{MaskSource::curvature, -1000, -1});
    made = simulation.read();
    EXPECT_EQ(mask_at(made, 40, 5), 1) << "the bend is a hollow";
    EXPECT_EQ(mask_at(made, 41, 5), 0);
    simulation.apply(MakeMask{MaskSource::depth, 1, 10});
    made = simulation.read();
    EXPECT_EQ(mask_at(made, 7, 40), 1);
    EXPECT_EQ(mask_at(made, 8, 40), 0);
    simulation.apply(MakeMask{MaskSource::itself, 0, 0, 0, MaskJoin::replace, true});
    made = simulation.read();
    EXPECT_EQ(mask_at(made, 7, 40), 0);
    EXPECT_EQ(mask_at(made, 8, 40), 1);
}

TEST(Mask, JoinsWithWhatIsPainted) {
    const gpu::Context context;
    Simulation simulation(bend(81), Parameters(simulation_parameters()), undo_bytes);
    simulation.apply(MakeMask{MaskSource::height, 0, 120});                            // x <= 44
    simulation.apply(MakeMask{MaskSource::height, 110, 300, 0, MaskJoin::intersect});  // x >= 42
    TerrainState made = simulation.read();
    for (const auto& [x, mask] : {std::pair(41, 0.0F), {42, 1.0F}, {44, 1.0F}, {45, 0.0F}})
        EXPECT_EQ(mask_at(made, x, 9), mask) << x;
    simulation.apply(MakeMask{MaskSource::height, 200, 300, 0, MaskJoin::add});
    simulation.apply(MakeMask{MaskSource::height, 110, 110, 0, MaskJoin::subtract});
    made = simulation.read();
    for (const auto& [x, mask] : {std::pair(42, 0.0F), {43, 1.0F}, {59, 0.0F}, {60, 1.0F}})
        EXPECT_EQ(mask_at(made, x, 9), mask) << x;
}

TEST(Mask, LimitsEveryKindOfDab) {
    const gpu::Context context;
    Simulation simulation(bend(81), Parameters(simulation_parameters()), undo_bytes);
    simulation.apply(MakeMask{MaskSource::height, 0, 100});
    const TerrainState before = simulation.read();
    Dab dab;
    dab.masked = true;
    dab.amount_m = 10;
    dab.blend = 1;
    dab.target_m = 0.5;
    for (const Material material : {Material::bedrock, Material::water, Material::hardness}) {
        dab.material = material;
        simulation.apply(everywhere(before.grid, dab));
    }
    const TerrainState after = simulation.read();
    for (int x = 0; x < 81; ++x) {
        const std::size_t i = 20 * 81 + static_cast<std::size_t>(x);
        const bool open = x <= 40;
        EXPECT_EQ(after.bedrock[i].x - before.bedrock[i].x, open ? 10 : 0) << x;
        EXPECT_EQ(after.water[i].x, open ? 10 : 0) << x;
        EXPECT_EQ(after.painted[i].x, open ? 0.5F : 0) << x;
    }
    // What the mask let through is booked.
    EXPECT_NEAR(simulation.ledger().closing_error_of_moved(), 0, 1e-9);
}

TEST(Blur, KeepsSlopesAndTheLedgerAndSmooths) {
    const gpu::Context context;
    Simulation simulation(bend(81), Parameters(simulation_parameters()), undo_bytes);
    simulation.apply(Blur{30});
    const TerrainState after = simulation.read();
    const auto height = [&](int x) {
        return static_cast<double>(after.bedrock[20 * 81 + x].x) + after.bedrock[20 * 81 + x].y;
    };
    // Over the corner of the bend: the mean of 5 m a sample on one side, by the Gaussian's weights.
    double mean = 0;
    double weights = 0;
    for (int k = -12; k <= 12; ++k) {
        const double weight = std::exp(-0.5 * k * k / 9.0);
        weights += weight;
        mean += weight * 5 * std::max(k, 0);
    }
    EXPECT_NEAR(height(40) - 100, mean / weights, 1e-5);
    EXPECT_NEAR(height(60), 200, 1e-4);
    EXPECT_EQ(height(10), 100);
    const LedgerReading ledger = simulation.ledger();
    EXPECT_NEAR(ledger.closing_error_m3(), 0, 1e-6 * ledger.deposited_m3);
    EXPECT_GT(ledger.deposited_m3, 1000);
}

TEST(WholeMap, OffsetScaleAndBlendAreExact) {
    const gpu::Context context;
    Simulation simulation(bend(65), Parameters(simulation_parameters()), undo_bytes);
    const Grid grid = simulation.terrain().grid();
    Dab offset;
    offset.amount_m = 25;
    simulation.apply(everywhere(grid, offset));
    Dab scale;
    scale.mode = BrushMode::flatten;
    scale.blend = 1 - 3.0;
    scale.target_m = 125;
    simulation.apply(everywhere(grid, scale));
    for (int x = 0; x < 65; ++x)
        EXPECT_NEAR(simulation.read().bedrock[static_cast<std::size_t>(x)].x,
                    125 + 15.0 * std::max(0, x - 32), 1e-4);
    // The terrain as its own stamp, over the whole map: it becomes what it was.
    simulation.apply(ChooseStamp{{}, {0, 0, grid.width_m(), grid.height_m()}, nullptr});
    Dab level;
    level.mode = BrushMode::flatten;
    level.blend = 1;
    simulation.apply(everywhere(grid, level));
    Dab stamp;
    stamp.mode = BrushMode::stamp;
    stamp.blend = 1;
    stamp.amount_m = simulation.stamp()->relief_m;
    stamp.target_m = 125;
    stamp.stamp = {StampMode::replace, {grid.width_m() / 2, grid.height_m() / 2}, 0, false};
    simulation.apply(everywhere(grid, stamp));
    const TerrainState after = simulation.read();
    for (int y : {0, 31, 64})
        for (int x = 0; x < 65; ++x)
            EXPECT_NEAR(after.bedrock[static_cast<std::size_t>(y) * 65 + x].x,
                        125 + 15.0 * std::max(0, x - 32), 0.01);
}

}  // namespace
}  // namespace talus

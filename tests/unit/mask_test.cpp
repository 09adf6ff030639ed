// Masks out of the terrain, blurs, and what they limit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/error.h"
#include "sim/gpu/context.h"
#include "sim/journal.h"
#include "sim/simulation.h"
#include "sim/simulation_parameters.h"

namespace talus::mask_test {
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

// s²(3 − 2s) between `from` and `to`.
double step_of(double value, double from, double to) {
    if (value >= to) return 1;
    if (value <= from) return 0;
    const double s = (value - from) / (to - from);
    return s * s * (3 - 2 * s);
}

// Ground from −400 m up, whose slopes grow from 0 to 89.9° eastwards and turn with the row, and water that
// deepens southwards.
TerrainState of_all_slopes() {
    const Grid grid{361, 40, 10, 12};
    std::vector<float> heights;
    std::vector<double> along(static_cast<std::size_t>(grid.nx), -400);
    for (int x = 1; x < grid.nx; ++x)
        along[static_cast<std::size_t>(x)] =
            along[static_cast<std::size_t>(x) - 1] + 10 * std::tan(glm::radians((x - 0.5) * 89.9 / grid.nx));
    for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x)
            heights.push_back(
                static_cast<float>(along[static_cast<std::size_t>(x)] + 3 * std::sin(0.7 * y) * y));
    TerrainState state = bedrock_terrain(grid, heights);
    for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x) state.water.emplace_back(0.1F * static_cast<float>(y), 0, 0, 0);
    return state;
}

// Every source against its formula in double, over its whole range, on both sides of its band.
TEST(Mask, EverySourceFollowsItsFormula) {
    const gpu::Context context;
    const TerrainState state = of_all_slopes();
    const Grid& grid = state.grid;
    const std::vector<float> ground = state.ground();
    const auto height = [&](int x, int y) {
        const int column = std::clamp(x, 0, grid.nx - 1);
        const int row = std::clamp(y, 0, grid.ny - 1);
        return static_cast<double>(ground[static_cast<std::size_t>(row) * grid.nx + column]);
    };
    const Rectangle rectangle{305, 100, 2004, 290};
    const auto value = [&](MaskSource source, int x, int y) {
        const double east = (height(x + 1, y) - height(x - 1, y)) / (2 * grid.dx);
        const double south = (height(x, y + 1) - height(x, y - 1)) / (2 * grid.dy);
        const double bend = (height(x + 1, y) - 2 * height(x, y) + height(x - 1, y)) / (grid.dx * grid.dx) +
                            (height(x, y + 1) - 2 * height(x, y) + height(x, y - 1)) / (grid.dy * grid.dy);
        switch (source) {
            case MaskSource::height:
                return height(x, y);
            case MaskSource::slope:
                return glm::degrees(std::atan(std::hypot(east, south)));
            case MaskSource::curvature:
                return -1000 * bend;
            case MaskSource::rectangle: {
                const glm::dvec2 place(x * grid.dx, (grid.ny - 1 - y) * grid.dy);
                const glm::dvec2 low(rectangle.west_m, rectangle.south_m);
                const glm::dvec2 high(rectangle.east_m, rectangle.north_m);
                return glm::length(glm::max(glm::max(low - place, place - high), glm::dvec2(0)));
            }
            default:
                return static_cast<double>(state.water[static_cast<std::size_t>(y) * grid.nx + x].x);
        }
    };
    const std::vector<MaskSettings> all = {
        {MaskSource::slope, 35, 80, 6},
        {MaskSource::slope, 30, 90, 5},
        {MaskSource::slope, 0, 5, 2},
        {MaskSource::slope, 80, 89, 3},
        {MaskSource::slope, 45, 45, 45},
        {MaskSource::slope, 20, 40, 0},
        {MaskSource::slope, 0, 90, 10},
        {MaskSource::height, -100, 300, 200},
        {MaskSource::height, -1e6, 0, 50},
        {MaskSource::height, 500, 1e6, 0},
        {MaskSource::curvature, -100, -1, 20},
        {MaskSource::curvature, 5, 1e6, 300},
        {MaskSource::depth, 1, 2, 0.5},
        {MaskSource::depth, 0.05, 1e6, 0.02},
        {MaskSource::rectangle, 0, 0, 55, MaskJoin::replace, false, rectangle},
        {MaskSource::rectangle, 0, 30, 0, MaskJoin::replace, false, rectangle}};
    Simulation simulation(state, Parameters(simulation_parameters()), undo_bytes);
    for (const MaskSettings& settings : all) {
        simulation.apply(settings);
        const TerrainState made = simulation.read();
        double largest = 0;
        int ones = 0;
        int zeros = 0;
        for (int y = 0; y < grid.ny; ++y)
            for (int x = 0; x < grid.nx; ++x) {
                const double v = value(settings.source, x, y);
                const double below = settings.low - settings.fade;
                const double above = settings.high + settings.fade;
                // Where it jumps, floats may fall on the other side.
                const double room = 1e-4 * std::max(1.0, std::abs(v));
                if (settings.fade == 0 &&
                    (std::abs(v - settings.low) < room || std::abs(v - settings.high) < room))
                    continue;
                const double expected = step_of(v, below, settings.low) *
                                        (v <= settings.high ? 1 : 1 - step_of(v, settings.high, above));
                const double is = mask_at(made, x, y);
                ones += is == 1 ? 1 : 0;
                zeros += is == 0 ? 1 : 0;
                // A float's height, 24 bits, in a difference over 10 m, against the fade.
                const double slack = 2e-6 + 4 * room / std::max(settings.fade, room);
                largest = std::max(largest, std::abs(is - expected) - (settings.fade == 0 ? 0 : slack));
            }
        EXPECT_LE(largest, 0) << mask_source_names()[static_cast<std::size_t>(settings.source)] << " "
                              << settings.low << " to " << settings.high << ", fade " << settings.fade;
        EXPECT_GT(ones + zeros, 0);
    }
}

// Of what runs left behind: each number of a layer is what the mask is made of, and where there is none it is
// 0.
TEST(Mask, FollowsWhatARunLeftBehind) {
    const gpu::Context context;
    TerrainState state = bend(81);
    const std::size_t count = state.grid.count();
    state.water.assign(count, glm::vec4(0));
    state.water.back().x = 0.5F;
    state.inundation.assign(count, glm::vec2(0));
    state.flow.assign(count, glm::vec2(0));
    state.worn_by_water.assign(count, glm::vec4(0));
    state.worn_by_hand.assign(count, glm::vec4(0));
    for (std::size_t i = 0; i < count; ++i) {
        const auto column = static_cast<float>(i % 81);
        state.inundation[i] = {column > 20 ? 3 + column : 0, 10 * column};
        state.flow[i] = {1e7F * column, 0};
        state.worn_by_water[i] = {0.5F * column, 0, 2 * column, 0};
        state.worn_by_hand[i] = {0.25F * column, 0, column, 0};
        state.regolith[i].x = 0.1F * column;
    }
    Simulation simulation(state, Parameters(simulation_parameters()), undo_bytes);
    const auto last_at = [&](MaskSource source, double low, double high) {
        simulation.apply(MakeMask{source, low, high});
        const TerrainState made = simulation.read();
        int first = -1;
        int last = -1;
        for (int x = 0; x < 81; ++x)
            if (mask_at(made, x, 33) == 1) {
                if (first < 0) first = x;
                last = x;
            }
        return std::pair(first, last);
    };
    EXPECT_EQ(last_at(MaskSource::largest_depth, 1, 40), std::pair(21, 37));
    EXPECT_EQ(last_at(MaskSource::arrival, 0, 305), std::pair(21, 30)) << "it arrived nowhere else";
    EXPECT_EQ(last_at(MaskSource::flow, 4.5e7, 6e8), std::pair(5, 60));
    EXPECT_EQ(last_at(MaskSource::wear, 7.4, 15.1), std::pair(10, 20)) << "0.75 a column";
    EXPECT_EQ(last_at(MaskSource::deposition, 29, 91), std::pair(10, 30)) << "3 a column";
    EXPECT_EQ(last_at(MaskSource::regolith, 0.95, 2.05), std::pair(10, 20));
    EXPECT_EQ(last_at(MaskSource::difference, 1, 1e6), std::pair(-1, -1));
    Dab dab;
    dab.x_m = dab.y_m = 400;
    dab.radius_m = 100;
    dab.amount_m = 10;
    simulation.apply(dab);
    simulation.apply(MakeMask{MaskSource::difference, 1, 1e6});
    const TerrainState raised = simulation.read();
    EXPECT_EQ(mask_at(raised, 40, 40), 1);
    EXPECT_EQ(mask_at(raised, 60, 40), 0);

    Simulation bare(bend(81), Parameters(simulation_parameters()), undo_bytes);
    for (const MaskSource source : {MaskSource::largest_depth, MaskSource::flow, MaskSource::wear,
                                    MaskSource::deposition, MaskSource::regolith, MaskSource::depth}) {
        bare.apply(MakeMask{source, -1, 1});
        EXPECT_EQ(mask_at(bare.read(), 9, 9), 1);
        bare.apply(MakeMask{source, 1, 2});
        EXPECT_EQ(mask_at(bare.read(), 9, 9), 0);
    }
    bare.apply(MakeMask{MaskSource::arrival, 0, 1e6});
    EXPECT_EQ(mask_at(bare.read(), 9, 9), 0);
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

TEST(Mask, ARectangleIsKeptInJournals) {
    Journal journal;
    MakeMask make{MaskSource::rectangle, 0, 0, 12.5, MaskJoin::add, true, {1.25, 2, 300.1, 400}};
    journal.record(make);
    const JournalFile read = read_journal(write_journal({}, journal), "rectangle");
    ASSERT_EQ(read.operations.size(), 1U);
    EXPECT_EQ(std::get<MakeMask>(read.operations[0]), make);

    const gpu::Context context;
    Simulation simulation(bend(81), Parameters(simulation_parameters()), undo_bytes);
    make.rectangle.east_m = 1;
    EXPECT_THROW(simulation.apply(make), Error);
    EXPECT_FALSE(simulation.can_undo());
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
    scale.effect = FlattenDab{};
    scale.blend = 1 - 3.0;
    scale.target_m = 125;
    simulation.apply(everywhere(grid, scale));
    for (int x = 0; x < 65; ++x)
        EXPECT_NEAR(simulation.read().bedrock[static_cast<std::size_t>(x)].x,
                    125 + 15.0 * std::max(0, x - 32), 1e-4);
    // The terrain as its own stamp, over the whole map: it becomes what it was.
    simulation.apply(ChooseStamp{{}, {0, 0, grid.width_m(), grid.height_m()}, nullptr});
    Dab level;
    level.effect = FlattenDab{};
    level.blend = 1;
    simulation.apply(everywhere(grid, level));
    Dab stamp;
    stamp.blend = 1;
    stamp.amount_m = simulation.stamp()->relief_m;
    stamp.target_m = 125;
    stamp.effect = StampDab{StampMode::replace, {grid.width_m() / 2, grid.height_m() / 2}, 0, false};
    simulation.apply(everywhere(grid, stamp));
    const TerrainState after = simulation.read();
    for (int y : {0, 31, 64})
        for (int x = 0; x < 65; ++x)
            EXPECT_NEAR(after.bedrock[static_cast<std::size_t>(y) * 65 + x].x,
                        125 + 15.0 * std::max(0, x - 32), 0.01);
}

}  // namespace
}  // namespace talus::mask_test

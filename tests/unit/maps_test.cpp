// Maps of flow, wear and deposition: their sums are what the ledger says, and who counts them changes nothing
// else.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

#include "app/claims/differing_bits.h"
#include "sim/gpu/context.h"
#include "sim/simulation.h"
#include "sim/terrain/generate.h"
#include "sim/terrain/layers.h"
#include "sim/terrain/reshape.h"
#include "sim/terrain/state_hash.h"
#include "tests/scenes/parameters_with.h"

namespace talus::maps_test {
namespace {

using claims::differing_bits;

double sum_of_output(const TerrainState& state, const std::string& name) {
    const std::vector<float> values = output_of(state, name);
    return std::accumulate(values.begin(), values.end(), 0.0);
}

double ground_m3(const TerrainState& state) {
    double sum = 0;
    for (std::size_t i = 0; i < state.bedrock.size(); ++i) {
        const glm::dvec2 words = glm::dvec2(state.bedrock[i]) + glm::dvec2(state.regolith[i]);
        sum += words.x + words.y;
    }
    return sum * state.grid.dx * state.grid.dy;
}

double flow_of_columns(const TerrainState& state, int first, int end) {
    const std::vector<float> flow = output_of(state, "flow");
    double sum = 0;
    for (int row = 0; row < state.grid.ny; ++row)
        for (int column = first; column < end; ++column)
            sum += flow[static_cast<std::size_t>(row) * state.grid.nx + column];
    return sum;
}

void play(Simulation& simulation, int ticks) {
    simulation.apply(Ticks{ticks});
}

// A slope that falls to the east, rippled along its fall, with walls beside it and behind.
TerrainState slope_to_the_east(const Grid& grid) {
    std::vector<float> heights;
    for (int row = 0; row < grid.ny; ++row)
        for (int column = 0; column < grid.nx; ++column)
            heights.push_back(static_cast<float>(200 - 0.5 * column +
                                                 0.3 * std::sin(0.7 * column) * std::cos(0.4 * column)));
    return bedrock_terrain(grid, heights);
}

class MapsOfEitherOrder : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Maps, MapsOfEitherOrder, testing::Values(1, 2));

// Straight to the edge: what passes the last column has left, what passes any other passed the next one, or
// stays.
TEST_P(MapsOfEitherOrder, FlowThroughTheEdgeIsTheWaterThatLeft) {
    const gpu::Context context;
    Parameters all = parameters_with({"time.tick_s=5", "water.rain=400", "water.boundary.north=wall",
                                      "water.boundary.south=wall", "water.boundary.west=wall",
                                      "thermal.on=false", "maps.count=always"});
    all.set("water.order", GetParam());
    Simulation simulation(slope_to_the_east({90, 40, 6, 5}), all);
    play(simulation, 120);
    const LedgerReading ledger = simulation.ledger();
    const TerrainState end = simulation.read();
    ASSERT_GT(ledger.water_out, 1000);
    EXPECT_NEAR(flow_of_columns(end, 89, 90) / ledger.water_out, 1, 1e-6);
    EXPECT_LT(flow_of_columns(end, 40, 41), 0.6 * ledger.water_out);
}

// A steady river brings its discharge through every column that it crosses.
TEST_P(MapsOfEitherOrder, FlowOfARiverPassesEachOfItsColumns) {
    const gpu::Context context;
    Parameters all = parameters_with({"time.tick_s=4", "water.boundary.north=wall",
                                      "water.boundary.south=wall", "water.boundary.west=inflow",
                                      "water.inflow=150", "thermal.on=false", "maps.count=always"});
    all.set("water.order", GetParam());
    const Grid grid{120, 30, 5, 5};
    TerrainState start = slope_to_the_east(grid);
    Simulation simulation(start, all);
    play(simulation, 100);
    const double before = flow_of_columns(simulation.read(), 60, 61);
    play(simulation, 100);
    const TerrainState end = simulation.read();
    // Steady by then: 400 s of 150 m³/s, less what is still unsteady.
    EXPECT_NEAR((flow_of_columns(end, 60, 61) - before) / (400 * 150), 1, 1e-3);
}

TEST_P(MapsOfEitherOrder, WearAndDepositionAreTheChangeOfTheGround) {
    const gpu::Context context;
    Parameters all =
        parameters_with({"time.tick_s=2", "water.sea_level=45", "water.boundary.west=level",
                         "water.boundary.east=inflow", "water.inflow=500", "water.rain=300",
                         "erosion.on=true", "erosion.erodibility=20", "erosion.bedrock_erodibility=5",
                         "erosion.critical_shear=2", "erosion.porosity=0.3", "erosion.acceleration=30",
                         "thermal.repose_deg=24", "thermal.weathering=500", "thermal.rate_m2_per_s=20"});
    all.set("water.order", GetParam());
    const Grid grid{150, 97, 20, 25};
    const TerrainState start = bedrock_terrain(grid, generate_heights(grid, {"coast", 5, 1600}));
    Simulation simulation(start, all, 256U << 20U);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int i = 0; i < 12; ++i) {
        Dab dab;
        dab.effect = effect_of(i % 3 == 0 ? BrushMode::lower : BrushMode::raise);
        dab.x_m = grid.width_m() * unit(random);
        dab.y_m = grid.height_m() * unit(random);
        dab.radius_m = 300;
        dab.amount_m = 10 * unit(random);
        dab.material = i % 2 == 0 ? Material::bedrock : Material::regolith;
        simulation.apply(dab);
        if (i == 6) simulation.apply(Blur{40, false, false, nullptr});
        play(simulation, 5);
    }
    const TerrainState end = simulation.read();
    const double area_m2 = grid.dx * grid.dy;
    const double moved = (sum_of_output(end, "wear") + sum_of_output(end, "deposition")) * area_m2;
    const double net = (sum_of_output(end, "deposition") - sum_of_output(end, "wear")) * area_m2;
    ASSERT_GT(moved, 1e5);
    EXPECT_NEAR(net, ground_m3(end) - ground_m3(start), 1e-6 * moved);
    for (const char* agent : {"water", "slopes", "hand"}) {
        EXPECT_GT(sum_of_output(end, std::string("wear_by_") + agent), 0) << agent;
        EXPECT_GT(sum_of_output(end, std::string("deposition_by_") + agent), 0) << agent;
    }
    // And sample by sample.
    const std::vector<float> wear = output_of(end, "wear");
    const std::vector<float> deposition = output_of(end, "deposition");
    double most_off = 0;
    for (std::size_t i = 0; i < wear.size(); ++i) {
        const auto height = [&](const TerrainState& state) {
            const glm::dvec2 words = glm::dvec2(state.bedrock[i]) + glm::dvec2(state.regolith[i]);
            return words.x + words.y;
        };
        const double off = height(end) - height(start) - (deposition[i] - static_cast<double>(wear[i]));
        most_off = std::max(most_off, std::abs(off) / (1e-3 + wear[i] + deposition[i]));
    }
    EXPECT_LT(most_off, 1e-5);

    const std::uint64_t hash = state_hash(end);
    while (simulation.can_undo()) simulation.undo();
    const TerrainState undone = simulation.read();
    EXPECT_TRUE(undone.flow.empty() && undone.worn_by_water.empty() && undone.worn_by_slopes.empty() &&
                undone.worn_by_hand.empty());
    while (simulation.can_redo()) simulation.redo();
    EXPECT_EQ(state_hash(simulation.read()), hash);
}

// Settling goes on when erosion is turned off, the tool erode works by hand, and so does a blur by the mask.
TEST_P(MapsOfEitherOrder, CountAllThatMovesTheGround) {
    const gpu::Context context;
    Parameters all =
        parameters_with({"time.tick_s=2", "water.rain=300", "erosion.on=true", "erosion.erodibility=20",
                         "erosion.acceleration=30", "thermal.on=false", "maps.count=never"});
    all.set("water.order", GetParam());
    const Grid grid{100, 90, 20, 20};
    Simulation simulation(bedrock_terrain(grid, generate_heights(grid, {"mountains", 5, 900})), all);
    play(simulation, 10);
    simulation.apply(SetParameter{"erosion.on", false});
    simulation.apply(SetParameter{"maps.count", std::string("always")});
    const auto expect_counted = [&](const TerrainState& before, const TerrainState& after,
                                    const char* agent) {
        const double area_m2 = grid.dx * grid.dy;
        const auto gain = [&](const std::string& what) {
            return (sum_of_output(after, what + agent) - sum_of_output(before, what + agent)) * area_m2;
        };
        const double moved = gain("wear_by_") + gain("deposition_by_");
        EXPECT_GT(moved, 10) << agent;
        EXPECT_NEAR(gain("deposition_by_") - gain("wear_by_"), ground_m3(after) - ground_m3(before),
                    1e-5 * moved)
            << agent;
    };
    const TerrainState loaded = simulation.read();
    ASSERT_FALSE(loaded.suspended.empty());
    play(simulation, 5);
    const TerrainState settled = simulation.read();
    expect_counted(loaded, settled, "water");
    for (int i = 0; i < 5; ++i) {
        Dab dab;
        dab.x_m = 900 + 20 * i;
        dab.y_m = 900;
        dab.radius_m = 200;
        dab.effect = ErodeDab{5000, 2, 3000, i == 0, i == 4};
        simulation.apply(dab);
    }
    const TerrainState eroded = simulation.read();
    expect_counted(settled, eroded, "hand");
    simulation.apply(MakeMask{MaskSource::slope, 20, 90, 5});
    simulation.apply(Blur{60, false, true, nullptr});
    expect_counted(eroded, simulation.read(), "hand");
}

TEST_P(MapsOfEitherOrder, AreNotCountedWhereTheyAreOff) {
    const gpu::Context context;
    const Grid grid{150, 97, 20, 25};
    const TerrainState start = bedrock_terrain(grid, generate_heights(grid, {"coast", 5, 160}));
    const auto run = [&](bool counted) {
        Parameters all =
            parameters_with({"time.tick_s=2", "water.rain=300", "erosion.on=true", "erosion.erodibility=20",
                             "erosion.acceleration=30", "thermal.repose_deg=24"});
        all.set("water.order", GetParam());
        all.set("maps.count", std::string(counted ? "with erosion" : "never"));
        Simulation simulation(start, all);
        Dab dab;
        dab.x_m = dab.y_m = 1000;
        dab.radius_m = 400;
        dab.amount_m = 5;
        simulation.apply(dab);
        play(simulation, 20);
        return simulation.read();
    };
    const TerrainState on = run(true);
    const TerrainState off = run(false);
    EXPECT_TRUE(off.flow.empty() && off.worn_by_water.empty() && off.worn_by_slopes.empty() &&
                off.worn_by_hand.empty());
    EXPECT_FALSE(on.flow.empty() || on.worn_by_water.empty() || on.worn_by_slopes.empty() ||
                 on.worn_by_hand.empty());
    EXPECT_EQ(differing_bits(on.bedrock, off.bedrock), 0U);
    EXPECT_EQ(differing_bits(on.regolith, off.regolith), 0U);
    EXPECT_EQ(differing_bits(on.water, off.water), 0U);
    EXPECT_EQ(differing_bits(on.suspended, off.suspended), 0U);

    // Turned off on the way, they stay as they are.
    Parameters all =
        parameters_with({"time.tick_s=2", "water.rain=300", "thermal.repose_deg=24", "maps.count=always"});
    Simulation simulation(start, all);
    play(simulation, 5);
    const TerrainState before = simulation.read();
    simulation.apply(SetParameter{"maps.count", std::string("never")});
    play(simulation, 5);
    const TerrainState after = simulation.read();
    EXPECT_EQ(differing_bits(before.flow, after.flow), 0U);
    EXPECT_EQ(differing_bits(before.worn_by_slopes, after.worn_by_slopes), 0U);
    EXPECT_NE(differing_bits(before.water, after.water), 0U);
}

// Twice the samples a side: half the water passes each.
TEST(Maps, FlowOfAFinerTerrainIsThatOfItsNarrowerSamples) {
    const Grid grid{41, 31, 8, 8};
    TerrainState state = bedrock_terrain(grid, std::vector<float>(grid.count(), 5));
    state.flow.assign(grid.count(), glm::vec2(600, 0));
    state.worn_by_water.assign(grid.count(), glm::vec4(2, 0, 3, 0));
    const TerrainState fine = resampled(state, 81, 61);
    for (const glm::vec2& flow : fine.flow) EXPECT_NEAR(flow.x + flow.y, 300, 1e-4);
    for (const glm::vec4& worn : fine.worn_by_water) {
        EXPECT_NEAR(worn.x, 2, 1e-6);
        EXPECT_NEAR(worn.z, 3, 1e-6);
    }
}

}  // namespace
}  // namespace talus::maps_test

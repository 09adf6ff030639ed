// Water that follows tables, and sections through it, against what is known of them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/gpu/context.h"
#include "sim/simulation.h"
#include "sim/simulation_parameters.h"
#include "sim/terrain/gauge.h"
#include "sim/terrain/state_hash.h"
#include "tests/scenes/parameters_with.h"

namespace talus::tables_test {
namespace {

constexpr std::size_t undo_bytes = 256U << 20U;

std::uint64_t hash_of(const Simulation& simulation) {
    return state_hash(simulation.read());
}

// A wave that a table makes shows the gauges what the same wave of the built-in wave maker does. Where the
// least difference makes a tick another number of sub-steps, the scheme's own error shows: the grid is fine,
// so that this is small.
TEST(Tables, AWaveByATableIsTheBuiltInOne) {
    const gpu::Context context;
    const Grid grid{800, 4, 0.25, 0.25};
    constexpr double depth_m = 10;
    constexpr double height_m = 0.8;
    const auto made = [&](bool by_table) {
        Parameters all = parameters_with(
            {"time.tick_s=0.5", "water.sea_level=10", "water.boundary.west=wave", "water.boundary.east=open",
             "water.boundary.north=wall", "water.boundary.south=wall", "water.manning=0",
             "water.wave=solitary", "water.wave_height=0.8", "water.wave_depth=10"});
        Simulation simulation(bedrock_terrain(grid, std::vector<float>(grid.count(), 0.0F)), all);
        if (by_table) {
            // Synolakis 1987 (2.4): a row every 0.002 of what the wave takes.
            const double gamma = std::sqrt(3 * height_m / (4 * depth_m)) / depth_m;
            const double kappa = gamma * std::sqrt(9.81 * (depth_m + height_m));
            const double start_s = std::acosh(std::sqrt(1000.0)) / kappa;
            std::vector<TimeSeries::Row> rows;
            for (int i = 0; 0.002 * i / kappa < 40; ++i) {
                const double time_s = 0.002 * i / kappa;
                const double crest = std::cosh(kappa * (time_s - start_s));
                rows.push_back({time_s, height_m / (crest * crest)});
            }
            simulation.apply(SetParameter{"water.wave", std::string("series")});
            simulation.apply(DriveParameter{"water.wave_height_m", TimeSeries(std::move(rows))});
        }
        return simulation;
    };
    Simulation built_in = made(false);
    Simulation driven = made(true);
    double furthest = 0;
    double highest = 0;
    for (int tick = 0; tick < 70; ++tick) {
        built_in.apply(Ticks{1});
        driven.apply(Ticks{1});
        for (const double x_m : {20.0, 60.0, 150.0}) {
            const double expected = read_gauge(built_in.terrain(), x_m, 0.5).level_m();
            furthest =
                std::max(furthest, std::abs(read_gauge(driven.terrain(), x_m, 0.5).level_m() - expected));
            highest = std::max(highest, expected);
        }
    }
    fmt::print("a solitary wave by a table: gauges differ by at most {:.1e} of its height\n",
               furthest / height_m);
    EXPECT_LE(furthest, 1e-5 * height_m);
    EXPECT_GT(highest, depth_m + 0.9 * height_m) << "the wave must have come by";
}

// A tide: the lake behind an edge whose level follows a table goes with it, and so does a sea beyond an open
// edge.
TEST(Tables, ABasinFollowsTheSea) {
    const gpu::Context context;
    const Grid grid{60, 40, 10, 10};
    Simulation simulation(
        bedrock_terrain(grid, std::vector<float>(grid.count(), 0.0F)),
        parameters_with({"time.tick_s=5", "water.boundary.north=wall", "water.boundary.south=wall",
                         "water.boundary.east=wall", "water.boundary.west=level"}),
        undo_bytes);
    const std::uint64_t dry = hash_of(simulation);
    // A jump of its slope would make the basin swing.
    std::vector<TimeSeries::Row> rows;
    for (int i = 0; i <= 200; ++i)
        rows.push_back({20.0 * i, 7.5 - 1.5 * std::cos(0.01 * std::numbers::pi * i)});
    const TimeSeries tide(std::move(rows));
    simulation.apply(DriveParameter{"water.sea_level_m", tide});
    EXPECT_NEAR(read_gauge(simulation.terrain(), 300, 200).depth_m, 6, 1e-5) << "the sea fills at once";
    for (int i = 0; i < 960; ++i) {
        simulation.apply(Ticks{1});
        if (i % 60 != 59) continue;
        const double time_s = simulation.clock().simulated_s;
        EXPECT_NEAR(read_gauge(simulation.terrain(), 300, 200).level_m(), tide.at(time_s), 0.03)
            << "at " << time_s << " s";
    }
    simulation.end_entry();
    simulation.undo();
    simulation.undo();
    EXPECT_EQ(hash_of(simulation), dry);
    EXPECT_FALSE(simulation.parameters().is_given("water.sea_level_m"));
}

// A steady stream: what passes sections across it, straight and slanting, is what flows in.
TEST(Sections, AChannelPassesItsInflow) {
    const gpu::Context context;
    const Grid grid{240, 20, 10, 10};
    std::vector<float> heights(grid.count());
    for (std::size_t i = 0; i < heights.size(); ++i) heights[i] = 10 - 0.02F * static_cast<float>(i % 240);
    Simulation simulation(
        bedrock_terrain(grid, heights),
        parameters_with({"time.tick_s=10", "water.boundary.north=wall", "water.boundary.south=wall",
                         "water.boundary.west=inflow", "water.inflow=150", "water.manning=0.03"}));
    // Downstream, east, is on the right when one looks north.
    simulation.follow_sections(
        {{{600, 0}, {600, 190}}, {{1200, 190}, {1200, 0}}, {{1700, 0}, {1900, 190}}, {{0, 0}, {0, 190}}});
    simulation.apply(Ticks{300});
    const std::vector<double> before = simulation.section_volumes_m3();
    simulation.apply(Ticks{20});
    const std::vector<double> after = simulation.section_volumes_m3();
    for (const std::size_t s : {0U, 1U, 2U, 3U}) {
        const double discharge = (after[s] - before[s]) / 200;
        fmt::print("section {}: {:.4f} m³/s of 150\n", s + 1, discharge);
        EXPECT_NEAR(discharge, s == 1 ? -150 : 150, 0.005 * 150);
    }
}

}  // namespace
}  // namespace talus::tables_test

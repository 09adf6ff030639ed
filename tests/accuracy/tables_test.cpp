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
#include "sim/terrain/generate.h"
#include "sim/terrain/reshape.h"
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

// A river that comes in by conveyance is at once as uniform flow is further down: at its level, where it is
// deep.
TEST(Conveyance, AValleyTakesItsRiverAsUniformFlow) {
    const gpu::Context context;
    const Grid grid{200, 61, 10, 10};
    constexpr double slope = 0.004;
    constexpr double manning = 0.035;
    constexpr double river_m3_per_s = 400;
    // A valley floor of 40 m, and sides that rise by one in twenty.
    const auto side_m = [](int row) { return 0.05 * std::max(0, 10 * std::abs(row - 30) - 20); };
    std::vector<float> heights;
    for (int row = 0; row < grid.ny; ++row)
        for (int column = 0; column < grid.nx; ++column)
            heights.push_back(static_cast<float>(1000 - slope * grid.dx * column + side_m(row)));
    // Uniform flow by Manning's law, a strip each.
    const auto discharge = [&](double level_m, int row) {
        const double depth_m = std::max(0.0, level_m - side_m(row));
        return std::pow(depth_m, 5.0 / 3) / manning * std::sqrt(slope) * grid.dy;
    };
    double low_m = 0;
    double high_m = 20;
    for (int i = 0; i < 60; ++i) {
        const double level_m = (low_m + high_m) / 2;
        double sum = 0;
        for (int row = 0; row < grid.ny; ++row) sum += discharge(level_m, row);
        (sum < river_m3_per_s ? low_m : high_m) = level_m;
    }
    for (const bool by_conveyance : {true, false}) {
        Parameters all =
            parameters_with({"time.tick_s=10", "water.boundary.north=wall", "water.boundary.south=wall",
                             "water.boundary.west=inflow", "water.boundary.east=open", "water.inflow=400",
                             "water.inflow_slope=0.004", "water.manning=0.035"});
        if (by_conveyance) all.set_assignment("water.inflow_over=conveyance");
        Simulation simulation(bedrock_terrain(grid, heights), all);
        // Over dry ground its first steps are not so long that water piles up.
        simulation.apply(Ticks{5});
        float deepest_m = 0;
        for (const glm::vec2& reached : simulation.read().inundation)
            deepest_m = std::max(deepest_m, reached.x);
        EXPECT_TRUE(!by_conveyance || deepest_m < 1.1 * high_m) << deepest_m;
        simulation.apply(Ticks{295});
        const TerrainState end = simulation.read();
        const auto astray_at = [&](int column) {
            double astray = 0;
            for (int row = 0; row < grid.ny; ++row) {
                const double found = end.water[static_cast<std::size_t>(row) * grid.nx + column].z * grid.dy;
                astray += std::abs(found - discharge(high_m, row)) / river_m3_per_s;
            }
            return astray;
        };
        const auto depth_at = [&](int column) {
            return end.water[30U * grid.nx + static_cast<std::size_t>(column)].x;
        };
        fmt::print(
            "{}: depth {:.3f}, {:.3f} and {:.3f} m of {:.3f} at 5, 100 and 1000 m; of the discharge {:.1f}, "
            "{:.1f} "
            "and {:.1f} % elsewhere\n",
            by_conveyance ? "by conveyance" : "evenly", depth_at(0), depth_at(10), depth_at(100), high_m,
            100 * astray_at(0), 100 * astray_at(10), 100 * astray_at(100));
        EXPECT_NEAR(depth_at(100), high_m, 0.03 * high_m) << "uniform flow";
        EXPECT_NEAR(simulation.ledger().water_in / (3000 * river_m3_per_s), 1, 1e-6);
        if (by_conveyance) {
            EXPECT_LE(astray_at(0), 0.05);
            EXPECT_LE(astray_at(10), 0.1);
            EXPECT_NEAR(depth_at(10), high_m, 0.03 * high_m);
        } else {
            EXPECT_GE(astray_at(0), 0.5) << "the comparison must tell";
        }
    }
}

// A turned map with its edges turned gives the turned water, to the bit.
TEST(Conveyance, TurnsWithTheMap) {
    const gpu::Context context;
    const Grid grid{66, 41, 5, 4};
    const Parameters all = parameters_with(
        {"time.tick_s=5", "water.boundary.north=inflow", "water.inflow=60", "water.inflow_over=conveyance"});
    Simulation plain(bedrock_terrain(grid, generate_heights(grid, {"hills", 3, 30})), all);
    Simulation turned_first(plain.read(), all);
    turned_first.apply(Turn{1});
    for (Simulation* one : {&plain, &turned_first}) one->apply(Ticks{30});
    const std::vector<glm::vec4> wanted = turned(plain.read(), 1).water;
    const std::vector<glm::vec4> found = turned_first.read().water;
    std::size_t differing = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i) differing += wanted[i] != found[i] ? 1 : 0;
    EXPECT_EQ(differing, 0U);
    EXPECT_GT(plain.ledger().water_in, 8000);
}

// By a table, over two edges, on rough ground: what it brings is the table's integral.
TEST(Conveyance, BringsItsTablesIntegral) {
    const gpu::Context context;
    const Grid grid{90, 66, 5, 4};
    Simulation simulation(bedrock_terrain(grid, generate_heights(grid, {"mountains", 3, 200})),
                          parameters_with({"time.tick_s=5", "water.boundary.north=inflow",
                                           "water.boundary.south=wall", "water.boundary.west=inflow",
                                           "water.boundary.east=wall", "water.inflow_over=conveyance"}));
    const TimeSeries inflow({{0, 0}, {20, 90}, {20.1, 3}, {70, 60}, {80, 0}});
    simulation.apply(DriveParameter{"water.inflow", inflow});
    Dab rough = everywhere(grid, {});
    rough.material = Material::manning;
    rough.blend = 0.5;
    rough.target_m = 0.2;
    simulation.apply(rough);
    simulation.follow_sections(
        {{{0, 0}, {0, grid.height_m()}}, {{0, grid.height_m()}, {grid.width_m(), grid.height_m()}}});
    simulation.apply(Ticks{20});
    const double wanted_m3 = inflow.integral(0, 100);
    EXPECT_NEAR(simulation.ledger().water_in / wanted_m3, 1, 1e-6);
    // Each edge by its length; the sections lie along them, downstream on their right.
    const std::vector<double> volumes = simulation.section_volumes_m3();
    const double west_share = 66.0 * 4 / (66 * 4 + 90 * 5);
    EXPECT_NEAR(volumes[0] / wanted_m3, west_share, 1e-6);
    EXPECT_NEAR(volumes[1] / wanted_m3, 1 - west_share, 1e-6);
    // It comes in through the lowest ground alone.
    const TerrainState end = simulation.read();
    const std::vector<float> ground = end.ground();
    int wet = 0;
    for (int row = 0; row < grid.ny; ++row)
        wet += end.water[static_cast<std::size_t>(row) * grid.nx].x > 0.01 ? 1 : 0;
    EXPECT_GT(wet, 0);
    EXPECT_LT(wet, grid.ny / 2);
}

}  // namespace
}  // namespace talus::tables_test

// The water against exact solutions: relative L1 of depth (docs/numerics.md, "Water"; the table that this
// prints is in docs/benchmarks.md).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "app/claims/arithmetic.h"
#include "app/claims/exact_solutions.h"
#include "app/claims/histories.h"
#include "app/claims/twin_agreement.h"
#include "app/claims/water_scenes.h"
#include "sim/gpu/context.h"

namespace talus::water_test {
namespace {

using scenes::WaterRun;
using scenes::WaterScene;

double error_of(const WaterScene& scene) {
    const claims::SceneError error = claims::error_after(scene);
    fmt::print("{:<16} n {:>4}  order {}  L1 {:.3e}  {} sub-steps\n", scene.name, scene.grid.nx,
               scene.settings.order, error.relative_l1, error.substeps);
    return error.relative_l1;
}

double order_of(double coarse, double fine, double refinement) {
    return std::log(coarse / fine) / std::log(refinement);
}

TEST(Water, RitterAndStoker) {
    const gpu::Context context;
    for (const auto& make : {scenes::ritter, scenes::stoker}) {
        std::vector<double> errors;
        for (const int n : {100, 200, 400, 800}) errors.push_back(error_of(make(n)));
        EXPECT_LE(errors[0], make == scenes::ritter ? 9e-3 : 6e-3);
        EXPECT_GE(order_of(errors[0], errors[3], 8), 0.8);
        fmt::print("order {:.2f}\n", order_of(errors[0], errors[3], 8));
    }
}

TEST(Water, ThackerBowls) {
    const gpu::Context context;
    for (const auto& make : {scenes::thacker_radial, scenes::thacker_planar}) {
        std::vector<double> errors;
        for (const int n : {64, 128, 256}) errors.push_back(error_of(make(n)));
        EXPECT_LE(errors[1], make == scenes::thacker_radial ? 2.0e-2 : 1.5e-2);
        EXPECT_GE(order_of(errors[0], errors[2], 4), 1.5);
        fmt::print("order {:.2f}\n", order_of(errors[0], errors[2], 4));
    }
}

double volume_of(const TerrainState& state) {
    double sum = 0;
    for (const glm::vec4& water : state.water) sum += static_cast<double>(water.x) + water.y;
    return sum * state.grid.dx * state.grid.dy;
}

float lowest_depth_of(const TerrainState& state) {
    float lowest = state.water[0].x;
    for (const glm::vec4& water : state.water) lowest = std::min(lowest, water.x);
    return lowest;
}

std::size_t differing(const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (std::bit_cast<std::array<std::uint32_t, 4>>(a[i]) !=
            std::bit_cast<std::array<std::uint32_t, 4>>(b[i]))
            ++count;
    return count;
}

TEST(Water, ALakeAtRestStaysAtRest) {
    const gpu::Context context;
    for (const double datum_m : {0.0, 1000.0}) {
        const claims::LakeMoved moved = claims::lake_at_rest(datum_m, 2000);
        fmt::print("lake at rest, bed at {:+.0f} m: speed {:.1e} m/s, level {:.1e} m after {} sub-steps\n",
                   datum_m, moved.fastest_m_per_s, moved.level_m, moved.substeps);
        EXPECT_LE(moved.fastest_m_per_s, datum_m == 0 ? 1e-5 : 1e-4);
        EXPECT_LE(moved.level_m, 1e-6);
    }
}

// A lake that is kept awake by a ripple of a millimetre: faces do not rest then, and still nothing but the
// ripple moves, √(g/d) times its height: 3e-2 m/s where it reaches water of a centimetre.
TEST(Water, ARippleIsAllThatMovesInALake) {
    const gpu::Context context;
    std::vector<double> speeds;
    double fastest = 0;
    for (const double datum_m : {0.0, 1000.0}) {
        WaterScene scene = scenes::lake(128, datum_m);
        scene.water = [still = scene.water](double x, double y, double t) {
            glm::dvec3 water = still(x, y, t);
            if (water.x > 1) water.x += 1e-3 * std::sin(x / 40) * std::sin(y / 50);
            return water;
        };
        WaterRun run(scene.state(), scene.settings);
        fastest = 0;
        while (run.water.work().substeps < 500) {
            run.run(1, run.time_s() + 10);
            fastest = std::max(fastest, claims::fastest_of(run.read()));
        }
        fmt::print("ripple of 1 mm, bed at {:+.0f} m: speed {:.1e} m/s\n", datum_m, fastest);
        EXPECT_GT(fastest, 1e-4);
        EXPECT_LE(fastest, 3e-2);
        speeds.push_back(fastest);
    }
    // Where levels are sums of beds and depths, a bed at 1,000 m alone gives 1.8e-2 m/s.
    EXPECT_NEAR(speeds[0] / speeds[1], 1, 0.02);
}

TEST(Water, NothingIsLostInAClosedBasin) {
    const gpu::Context context;
    for (const int order : {1, 2}) {
        WaterScene scene = scenes::basin(128, 3);
        scene.settings.order = order;
        const TerrainState start = scene.state();
        WaterRun run(start, scene.settings);
        const double before = volume_of(start);
        double drift = 0;
        float lowest = 0;
        while (run.water.work().substeps < 6000) {
            run.run(1, run.time_s() + 40);
            const TerrainState now = run.read();
            drift = std::max(drift, std::abs(volume_of(now) / before - 1));
            lowest = std::min(lowest, lowest_depth_of(now));
        }
        const TerrainState end = run.read();
        const auto wet =
            std::count_if(end.water.begin(), end.water.end(), [](const glm::vec4& w) { return w.x > 0; });
        fmt::print(
            "closed basin, order {}: drift {:.1e}, lowest depth {:.1e} m, {} sub-steps, {} % wet, speed "
            "{:.2f} m/s\n",
            order, drift, lowest, run.water.work().substeps, 100 * wet / static_cast<long>(end.water.size()),
            claims::fastest_of(end));
        EXPECT_LE(drift, 1e-6);
        EXPECT_GE(lowest, 0);
    }
}

TEST(Water, TurnsAndMirrorsToTheBit) {
    const gpu::Context context;
    constexpr int n = 150;
    WaterScene scene = scenes::radial_dam(n, true);
    scene.settings.manning_s_per_m13 = 0.03;
    const TerrainState start = scene.state();
    WaterRun run(start, scene.settings);
    run.run(0.5, 12);
    const std::vector<glm::vec4> end = run.read().water;
    EXPECT_GT(differing(start.water, end), end.size() / 4);
    std::size_t mirrored = 0;
    std::size_t turned = 0;
    const auto same = [](glm::vec4 a, glm::vec4 b) {
        // 0 and -0 are one discharge.
        return a.x == b.x && a.y == b.y && a.z == b.z && a.w == b.w;
    };
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            const glm::vec4 here = end[static_cast<std::size_t>(y) * n + x];
            const glm::vec4 west = end[static_cast<std::size_t>(y) * n + (n - 1 - x)];
            // A quarter turn against the clock takes east to north: the sample here comes from (row, column).
            const glm::vec4 from = end[static_cast<std::size_t>(x) * n + (n - 1 - y)];
            if (!same(here, {west.x, west.y, -west.z, west.w})) ++mirrored;
            if (!same(here, {from.x, from.y, -from.w, from.z})) ++turned;
        }
    EXPECT_EQ(mirrored, 0U);
    EXPECT_EQ(turned, 0U);
}

TEST(Water, SkippingWhatRestsChangesNothing) {
    const gpu::Context context;
    for (const int order : {1, 2})
        for (const bool driven : {false, true}) {
            const claims::SkippedRest rest = claims::skipped_rest(order, driven, 50);
            EXPECT_EQ(rest.differing, 0U) << "order " << order << driven;
            fmt::print("order {}{}: {:.0f} % of the tiles active\n", order, driven ? ", driven" : "",
                       100.0 * static_cast<double>(rest.active_tiles) / static_cast<double>(rest.all_tiles));
            EXPECT_LT(rest.active_tiles, rest.all_tiles * 9 / 10) << "something must have slept";
        }
}

// Over ground of one roughness, and of a roughness that differs along the stream.
TEST(Water, MacDonaldsStream) {
    const gpu::Context context;
    for (const bool rough_in_places : {false, true}) {
        const WaterScene scene = scenes::macdonald(200, rough_in_places);
        WaterRun run(scene.state(), scene.settings);
        run.run(scene.tick_s, scene.end_s);
        const TerrainState end = run.read();
        const double depth = depth_error(scene, end, scene.end_s);
        double discharge = 0;
        for (int column = 0; column < scene.grid.nx; ++column)
            discharge += std::abs(end.water[static_cast<std::size_t>(column)].z - 2) / 2 / scene.grid.nx;
        fmt::print("MacDonald{}, n 200: L1 of depth {:.2e}, of discharge {:.2e}\n",
                   rough_in_places ? " over varied roughness" : "", depth, discharge);
        EXPECT_LE(depth, 1e-2);
        EXPECT_LE(discharge, 5e-3);
    }
}

TEST(Water, RainRunsOffRoughSlopesAtManningsDepth) {
    const gpu::Context context;
    for (const int order : {1, 2})
        for (const double slope : {0.1, 0.3, 0.58}) {
            const WaterScene scene = scenes::rain_on_slope(slope, order);
            WaterRun run(scene.state(), scene.settings);
            run.run(scene.tick_s, scene.end_s - 300);
            const WaterBooks before = run.water.read_books(scene.grid);
            run.run(scene.tick_s, scene.end_s);
            const WaterBooks after = run.water.read_books(scene.grid);
            const double outflow =
                (after.edges_out_m3 - before.edges_out_m3) / (after.rain_m3 - before.rain_m3);
            double depth = 0;
            double manning = 0;
            const TerrainState end = run.read();
            for (int row = 0; row < scene.grid.ny; ++row)
                for (int column = 0; column < scene.grid.nx; ++column) {
                    depth += end.water[static_cast<std::size_t>(row) * scene.grid.nx + column].x;
                    manning += scene.water((column + 0.5) * scene.grid.dx, 0, scene.end_s).x;
                }
            fmt::print(
                "rain on a slope of {}, order {}: outflow {:.4f} of the rain, depth {:.3f} of Manning's\n",
                slope, order, outflow, depth / manning);
            EXPECT_NEAR(outflow, 1, 0.01);
            EXPECT_NEAR(depth / manning, 1, 0.10);
        }
}

// A hollow of one sample in a steep flank: where slopes of level and depth are limited each by itself, the
// faces beside it stood as dams of metres, and rain on mountains filled thousands of them (it was so).
TEST(Water, AHollowOverflowsAtItsSill) {
    const gpu::Context context;
    WaterScene scene;
    scene.grid = {24, 24, 20, 20};
    scene.settings.manning_s_per_m13 = 0.03;
    scene.settings.rain_m_per_s = 0;
    scene.settings.edges.fill(EdgeKind::open);
    const auto hollow = [](double x, double y) { return std::abs(x - 250) < 1 && std::abs(y - 250) < 1; };
    // Falls steeply from the west and north; the sill, 0.7 m above the hollow, is in the east.
    scene.bed = [=](double x, double y) {
        if (hollow(x, y)) return 976.0;
        return x > 250 && std::abs(y - 250) < 1 ? 976.7 - 0.2 * (x - 270)
                                                : 990 + 0.6 * (250 - x) + 0.8 * std::abs(y - 250);
    };
    scene.water = [](double, double, double) { return glm::dvec3(0); };
    for (const int order : {1, 2}) {
        scene.settings.order = order;
        WaterRun run(scene.state(), scene.settings);
        run.springs = {{240, 240, 0.5}};  // world metres: the hollow's sample
        run.run(10, 3600);
        const TerrainState end = run.read();
        const float depth = end.water[11U * 24 + 12].x;
        fmt::print("a hollow with a sill of 0.7 m, order {}: {:.2f} m deep\n", order, depth);
        EXPECT_GT(depth, 0.7);
        EXPECT_LT(depth, 1.1);
        EXPECT_NEAR(
            run.water.read_books(scene.grid).edges_out_m3 / run.water.read_books(scene.grid).springs_m3, 1,
            0.3);
    }
}

// Bates, Horritt & Fewtrell 2010, 4.1: water driven over a flat rough bed at one speed.
TEST(Water, AFrictionWaveOnADryBed) {
    const gpu::Context context;
    WaterScene scene;
    scene.grid = {100, 4, 50, 50};
    scene.settings.manning_s_per_m13 = 0.03;
    scene.settings.edges[static_cast<std::size_t>(Edge::west)] = EdgeKind::inflow;
    scene.bed = [](double, double) { return 0.0; };
    scene.water = [](double x, double, double t) {
        const double h = x < t ? std::pow(7.0 / 3 * 0.03 * 0.03 * (t - x), 3.0 / 7) : 0;
        return glm::dvec3(h, h, 0);
    };
    WaterRun run(scene.state(), scene.settings);
    while (run.time_s() < 3600) {
        // Its inflow follows the solution at x = 0, at a speed of 1 m/s.
        run.settings.inflow_m3_per_s =
            scene.water(0, 0, run.time_s() + 2.5).y * scene.grid.ny * scene.grid.dy;
        run.tick(5);
    }
    const double error = depth_error(scene, run.read(), 3600);
    fmt::print("friction wave on a dry bed: L1 {:.2e}\n", error);
    EXPECT_LE(error, 0.02);
}

TEST(Water, ASolitaryWaveRunsUpABeach) {
    const gpu::Context context;
    const WaterScene scene = scenes::solitary_on_beach(1400);
    WaterRun run(scene.state(), scene.settings);
    const std::vector<float> ground = scene.state().ground();
    double highest = 0;
    while (run.time_s() < scene.end_s) {
        run.tick(scene.tick_s);
        const TerrainState now = run.read();
        for (int column = 0; column < scene.grid.nx; ++column) {
            const auto at = static_cast<std::size_t>(column);
            if (now.water[at].x < 5e-4F) continue;
            highest = std::max(highest, static_cast<double>(ground[at]) + now.water[at].x);
            break;
        }
    }
    fmt::print("solitary run-up: {:.4f} d, Synolakis 0.0890 d ({:+.1f} %)\n", highest,
               100 * (highest / 0.0890 - 1));
    EXPECT_NEAR(highest / 0.0890, 1, 0.05);
}

TEST(Water, SmallWavesTravelAtTheirSpeed) {
    const gpu::Context context;
    for (const glm::ivec2 waves : {glm::ivec2(1, 0), glm::ivec2(0, 1), glm::ivec2(1, 1)}) {
        const claims::WaveError error = claims::small_wave_error(waves.x, waves.y);
        fmt::print("small wave ({}, {}): speed {:+.3f} % off the square root of gd, amplitude {:.3f}\n",
                   waves.x, waves.y, 100 * error.speed, error.amplitude);
        EXPECT_LE(std::abs(error.speed), 0.005);
        EXPECT_GT(error.amplitude, 0.5);
    }
}

// Water that runs from an open edge down into the map must not draw more of itself in (it did: a copy beyond
// the edge is a spring that feeds itself, 38 % of the rain on a mountain).
TEST(Water, OpenEdgesBringNothingToGroundThatFallsInwards) {
    const gpu::Context context;
    // Below 0 m too: no sea stands there unless its level was given.
    for (const auto& [order, datum_m] : {std::pair(1, 100), {2, 100}, {2, -1000}}) {
        const WaterScene scene = scenes::rain_on_bowl(datum_m, order);
        WaterRun run(scene.state(), scene.settings);
        run.run(scene.tick_s, scene.end_s);
        const WaterBooks books = run.water.read_books(scene.grid);
        fmt::print("rain on a bowl at {:+} m, order {}: {:.2e} of the rain came in by open edges\n", datum_m,
                   order, books.edges_in_m3 / books.rain_m3);
        EXPECT_LE(books.edges_in_m3, 1e-3 * books.rain_m3);
    }
}

// 1 mm/h on 100 m of water at 1/60 s: 4.6e-9 m a tick, a thousandth of the depth's last digit.
TEST(Water, RainBelowTheLastDigitAddsUp) {
    const gpu::Context context;
    WaterScene scene;
    scene.grid = {64, 64, 10, 10};
    scene.settings.rain_m_per_s = 1e-3 / 3600;
    scene.bed = [](double, double) { return 0.0; };
    scene.water = [](double, double, double) { return glm::dvec3(100, 0, 0); };
    WaterRun run(scene.state(), scene.settings);
    for (int tick = 0; tick < 3600; ++tick) run.tick(1.0 / 60);
    double gained = 0;
    for (const glm::vec4& water : run.read().water) gained += (static_cast<double>(water.x) - 100) + water.y;
    gained /= 64 * 64;
    fmt::print("a minute of 1 mm/h on 100 m of water: {:.4e} m of {:.4e}\n", gained, 1e-3 / 60);
    EXPECT_NEAR(gained / (1e-3 / 60), 1, 1e-5);
    EXPECT_NEAR(run.water.read_books(scene.grid).rain_m3 / (gained * 640 * 640), 1, 1e-5);
}

TEST(Water, AgreesWithItsFloatTwinToTheBit) {
    const gpu::Context context;
    const bool rounds_as_ieee = claims::arithmetic_of_device().rounds_as_ieee();
    const claims::WaterCase cases[] = {
        {2, 0, 0, EdgeKind::wall, EdgeKind::wall, EdgeKind::wall, EdgeKind::wall},
        {1, 0.03, 0, EdgeKind::wall, EdgeKind::open, EdgeKind::level, EdgeKind::wall},
        {2, 0.03, 2e-4, EdgeKind::open, EdgeKind::level, EdgeKind::wall, EdgeKind::open},
        {2, 0, 0, EdgeKind::periodic, EdgeKind::periodic, EdgeKind::periodic, EdgeKind::periodic},
        {2, 0.02, 1e-4, EdgeKind::wave, EdgeKind::inflow, EdgeKind::level, EdgeKind::wave},
        {1, 0, 0, EdgeKind::inflow, EdgeKind::wave, EdgeKind::open, EdgeKind::inflow},
        {2, 0.02, 1e-4, EdgeKind::wave, EdgeKind::inflow, EdgeKind::level, EdgeKind::open, false, true},
        {1, 0.02, 1e-4, EdgeKind::inflow, EdgeKind::level, EdgeKind::wave, EdgeKind::inflow, true, true}};
    for (const claims::WaterCase& c : cases) {
        const claims::TwinAgreement agreement = water_against_twin(c);
        if (rounds_as_ieee) {
            EXPECT_EQ(agreement.differing, 0U)
                << "order " << c.order << ", north " << static_cast<int>(c.north);
        }
        EXPECT_GT(agreement.changed, agreement.samples / 3);
        fmt::print("float against double, order {}: L1 {:.1e}\n", c.order, agreement.of_double);
        EXPECT_LT(agreement.of_double, 1e-4);
    }
}

}  // namespace
}  // namespace talus::water_test

// The water against exact solutions: relative L1 of depth (docs/numerics.md, "Water"; the table that this
// prints is in docs/benchmarks.md).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "sim/gpu/context.h"
#include "sim/passes/water_twin.h"
#include "tests/scenes/water_scenes.h"

namespace talus {
namespace {

using scenes::WaterRun;
using scenes::WaterScene;

double error_of(const WaterScene& scene) {
    WaterRun run(scene.state(), scene.settings);
    run.run(scene.tick_s, scene.end_s);
    const double error = depth_error(scene, run.read(), scene.end_s);
    const Water::Work work = run.water.work();
    fmt::print("{:<16} n {:>4}  order {}  L1 {:.3e}  {} sub-steps\n", scene.name, scene.grid.nx,
               scene.settings.order, error, work.substeps);
    return error;
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

glm::dvec2 velocity_of(const glm::vec4& water) {
    const double h = water.x;
    const double factor = 2 * h / (h * h + std::max(h * h, 1e-12));
    return {factor * water.z, factor * water.w};
}

double fastest_of(const TerrainState& state) {
    double fastest = 0;
    for (const glm::vec4& water : state.water) fastest = std::max(fastest, glm::length(velocity_of(water)));
    return fastest;
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
        const WaterScene scene = scenes::lake(128, datum_m);
        const TerrainState start = scene.state();
        WaterRun run(start, scene.settings);
        run.settings.skips_rest = false;
        double fastest = 0;
        while (run.water.work().substeps < 2000) {
            run.run(1, run.time_s() + 20);
            fastest = std::max(fastest, fastest_of(run.read()));
        }
        const TerrainState end = run.read();
        double moved = 0;
        for (std::size_t i = 0; i < end.water.size(); ++i)
            moved = std::max(moved, std::abs(static_cast<double>(end.water[i].x) - start.water[i].x));
        fmt::print("lake at rest, bed at {:+.0f} m: speed {:.1e} m/s, level {:.1e} m after {} sub-steps\n",
                   datum_m, fastest, moved, run.water.work().substeps);
        EXPECT_LE(fastest, datum_m == 0 ? 1e-5 : 1e-4);
        EXPECT_LE(moved, 1e-6);
    }
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
            fastest_of(end));
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
    for (const int order : {1, 2}) {
        // Water that comes down into a corner of a dry map, and leaves its film behind.
        WaterScene scene = scenes::basin(320, 5);
        scene.settings.order = order;
        scene.settings.manning_s_per_m13 = 0.02;
        scene.water = [bed = scene.bed](double x, double y, double) {
            return glm::dvec3(x < 300 && y < 300 ? std::max(0.0, 6 - bed(x, y)) : 0, 0, 0);
        };
        const TerrainState start = scene.state();
        WaterRun sparse(start, scene.settings);
        WaterRun dense(start, scene.settings);
        dense.settings.skips_rest = false;
        for (int i = 0; i < 4; ++i) {
            sparse.run(1, sparse.time_s() + 25);
            dense.run(1, dense.time_s() + 25);
            ASSERT_EQ(differing(sparse.read().water, dense.read().water), 0U)
                << "after " << sparse.time_s() << " s";
        }
        const Water::Work skipped = sparse.water.work();
        const Water::Work all = dense.water.work();
        EXPECT_EQ(skipped.substeps, all.substeps);
        fmt::print("order {}: {:.1f} of {} tiles active\n", order,
                   static_cast<double>(skipped.tiles) / static_cast<double>(skipped.substeps), 25);
        EXPECT_LT(skipped.tiles, all.tiles * 9 / 10) << "something must have slept";
        EXPECT_GT(differing(start.water, sparse.read().water), start.water.size() / 20);
    }
}

template <typename Real>
maths::WaterTwin<Real> twin_of(const TerrainState& state, const WaterSettings& settings) {
    std::vector<Real> beds;
    std::vector<glm::vec<4, Real>> water;
    for (const float height : state.ground()) beds.push_back(height);
    for (const glm::vec4& texel : state.water) water.emplace_back(texel);
    return {state.grid, beds, water, settings};
}

TEST(Water, AgreesWithItsFloatTwinToTheBit) {
    const gpu::Context context;
    struct Case {
        int order;
        double manning;
        double rain;
        EdgeKind north, south, west, east;
    };
    const Case cases[] = {
        {2, 0, 0, EdgeKind::wall, EdgeKind::wall, EdgeKind::wall, EdgeKind::wall},
        {1, 0.03, 0, EdgeKind::wall, EdgeKind::open, EdgeKind::level, EdgeKind::wall},
        {2, 0.03, 2e-4, EdgeKind::open, EdgeKind::level, EdgeKind::wall, EdgeKind::open},
        {2, 0, 0, EdgeKind::periodic, EdgeKind::periodic, EdgeKind::periodic, EdgeKind::periodic},
        {2, 0.02, 1e-4, EdgeKind::wave, EdgeKind::wall, EdgeKind::level, EdgeKind::wave}};
    for (const Case& c : cases) {
        WaterScene scene = scenes::basin(97, 2);
        scene.grid.nx = 131;
        scene.grid.dy = 6;
        scene.settings.order = c.order;
        scene.settings.manning_s_per_m13 = c.manning;
        scene.settings.rain_m_per_s = c.rain;
        scene.settings.infiltration_m_per_s = c.rain / 3;
        scene.settings.edges = {c.north, c.south, c.west, c.east};
        scene.settings.level_m = 3;
        // One height over each tick: the device reads its time series between the points of a table.
        scene.settings.wave_form = WaveForm::solitary;
        scene.settings.wave_height_m = 0;
        const TerrainState start = scene.state();
        WaterRun run(start, scene.settings);
        auto twin = twin_of<float>(start, scene.settings);
        auto exact = twin_of<double>(start, scene.settings);
        for (int tick = 0; tick < 10; ++tick) {
            twin.tick(1, run.time_s());
            exact.tick(1, run.time_s());
            run.tick(1);
        }
        const std::vector<glm::vec4> end = run.read().water;
        EXPECT_EQ(differing(end, twin.read()), 0U)
            << "order " << c.order << ", north " << static_cast<int>(c.north);
        EXPECT_GT(differing(end, start.water), end.size() / 3);
        double missed = 0;
        double all = 0;
        const std::vector<glm::dvec4> in_double = exact.read();
        for (std::size_t i = 0; i < end.size(); ++i) {
            missed += std::abs(static_cast<double>(end[i].x) - in_double[i].x);
            all += in_double[i].x;
        }
        fmt::print("float against double after {} sub-steps, order {}: L1 {:.1e}\n",
                   run.water.work().substeps, c.order, missed / all);
        EXPECT_LT(missed / all, 1e-4);
    }
}

}  // namespace
}  // namespace talus

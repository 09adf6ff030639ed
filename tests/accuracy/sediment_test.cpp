// Erosion by water: exact answers, bounds, conservation, symmetry, skipping, and the twins.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "app/claims/arithmetic.h"
#include "app/claims/twin_agreement.h"
#include "app/claims/water_scenes.h"
#include "sim/gpu/context.h"

namespace talus::sediment_test {
namespace {

using scenes::WaterRun;
using scenes::WaterScene;

// Coarse silt in a stream that carries much: all parts of the exchange act.
SedimentSettings silt() {
    SedimentSettings settings;
    settings.carried = true;
    settings.regolith_m_per_s_pa = 4e-6;
    settings.bedrock_m_per_s_pa = 4e-7;
    settings.critical_pa = 2;
    settings.settling_m_per_s = 0.02;
    settings.porosity = 0.3;
    settings.acceleration = 20;
    return settings;
}

// Water that sloshes over bedrock with regolith of varied depth on it, bare in places, and hardness painted.
WaterScene eroding_basin(int n, int seed) {
    WaterScene scene = scenes::basin(n, seed);
    scene.settings.manning_s_per_m13 = 0.03;
    scene.settings.sediment = silt();
    return scene;
}
TerrainState with_regolith(const WaterScene& scene) {
    TerrainState state = scene.state();
    const Grid& grid = scene.grid;
    for (std::size_t i = 0; i < grid.count(); ++i) {
        const auto x = static_cast<float>(i % static_cast<std::size_t>(grid.nx));
        const float depth = std::max(0.0F, 0.02F * std::sin(0.2F * x) + 0.005F);
        state.regolith[i].x = depth;
        state.bedrock[i].x -= depth;
    }
    return state;
}

template <typename Texel>
std::size_t differing(const std::vector<Texel>& a, const std::vector<Texel>& b) {
    if (a.size() != b.size()) return std::max(a.size(), b.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) count += a[i] == b[i] ? 0 : 1;
    return count;
}

std::vector<glm::vec4> solid_of(const TerrainState& state) {
    std::vector<glm::vec4> solid;
    for (std::size_t i = 0; i < state.bedrock.size(); ++i)
        solid.emplace_back(state.bedrock[i], state.regolith[i]);
    return solid;
}
std::vector<glm::vec2> load_of(const TerrainState& state) {
    return state.suspended.empty() ? std::vector<glm::vec2>(state.grid.count(), glm::vec2(0))
                                   : state.suspended;
}

TEST(Sediment, AgreesWithItsFloatTwinToTheBit) {
    const gpu::Context context;
    const bool rounds_as_ieee = claims::arithmetic_of_device().rounds_as_ieee();
    const claims::WaterCase cases[] = {
        {2, 0, 0, EdgeKind::wall, EdgeKind::wall, EdgeKind::wall, EdgeKind::wall},
        {1, 0, 0, EdgeKind::wall, EdgeKind::open, EdgeKind::level, EdgeKind::wall},
        {2, 0, 2e-4, EdgeKind::open, EdgeKind::level, EdgeKind::inflow, EdgeKind::open},
        {2, 0, 0, EdgeKind::periodic, EdgeKind::periodic, EdgeKind::periodic, EdgeKind::periodic},
        {1, 0, 1e-4, EdgeKind::wave, EdgeKind::inflow, EdgeKind::level, EdgeKind::wave},
        {2, 0, 2e-4, EdgeKind::inflow, EdgeKind::level, EdgeKind::inflow, EdgeKind::open, false, true}};
    for (const claims::WaterCase& c : cases) {
        const claims::TwinAgreement agreement = sediment_against_twin(c);
        if (rounds_as_ieee) {
            EXPECT_EQ(agreement.differing, 0U) << "order " << c.order;
        }
        EXPECT_GT(agreement.changed, agreement.samples / 8);
        fmt::print("sediment, float against double, order {}: L1 of the change of the ground {:.1e}\n",
                   c.order, agreement.of_double);
        EXPECT_LT(agreement.of_double, 1e-3);
    }
}

// A stream on a plane in steady flow: along it, and in time, concentration nears equilibrium as
// c = c_e + (c_0 - c_e) exp(-w x / q), and exp(-w t / h) (../docs/numerics.md, "Sediment").
TEST(Sediment, NearsEquilibriumAtTheAnalyticRate) {
    const gpu::Context context;
    const double q = 2;
    const double slope = 0.002;
    const double manning = 0.03;
    const double h = std::pow(manning * q / std::sqrt(slope), 0.6);
    const double settling = 0.01;
    const double equilibrium = 1e-4;
    WaterScene scene;
    scene.grid = {200, 4, 5, 5};
    scene.settings.manning_s_per_m13 = manning;
    scene.settings.edges = {EdgeKind::wall, EdgeKind::wall, EdgeKind::inflow, EdgeKind::level};
    scene.settings.level_m = 10 - slope * 997.5 + h;
    scene.settings.inflow_m3_per_s = q * 20;
    scene.bed = [&](double x, double) { return 10 - slope * x; };
    scene.water = [&](double, double, double) { return glm::dvec3(h, q, 0); };
    SedimentSettings& sediment = scene.settings.sediment;
    sediment.carried = true;
    sediment.critical_pa = 5;
    sediment.settling_m_per_s = settling;
    // E = erodibility * excess = settling * equilibrium.
    sediment.regolith_m_per_s_pa = settling * equilibrium / (1000 * 9.81 * h * slope - 5);
    for (const double inflow : {0.0, 3e-4}) {
        sediment.inflow_concentration = inflow;
        TerrainState start = scene.state();
        for (std::size_t i = 0; i < scene.grid.count(); ++i) {
            start.bedrock[i].x -= 1;
            start.regolith[i].x = 1;
        }
        WaterRun run(start, scene.settings);
        const auto concentration = [&](int column) {
            const TerrainState now = run.read();
            const std::size_t at = 200 + static_cast<std::size_t>(column);
            return static_cast<double>(now.suspended[at].x) / now.water[at].x;
        };
        // Where the inflow has not come yet, it is time alone that counts.
        run.run(1, 100);
        const double in_time = concentration(120) / (equilibrium * (1 - std::exp(-settling * 100 / h)));
        run.run(1, 1500);
        double missed = 0;
        double all = 0;
        for (int column = 0; column < 200; ++column) {
            const double exact =
                equilibrium + (inflow - equilibrium) * std::exp(-settling * (column + 0.5) * 5 / q);
            missed += std::abs(concentration(column) - exact);
            all += exact;
        }
        const double reached =
            concentration(199) / (equilibrium + (inflow - equilibrium) * std::exp(-settling * 1000 / q));
        fmt::print("stream, inflow of {}: L1 along it {:.2e}, after 100 s {:+.2f} %, at its end {:+.2f} %\n",
                   inflow, missed / all, 100 * (in_time - 1), 100 * (reached - 1));
        EXPECT_LE(missed / all, 0.01);
        EXPECT_NEAR(in_time, 1, 0.01);
        EXPECT_NEAR(reached, 1, 0.01);
    }
}

// Carried through a dam break on a dry, rough bed, concentration stays between 0 and its first maximum.
TEST(Sediment, APulseStaysBelowItsFirstMaximum) {
    const gpu::Context context;
    for (const int order : {1, 2}) {
        WaterScene scene = scenes::basin(160, 6);
        scene.settings.order = order;
        scene.settings.manning_s_per_m13 = 0.02;
        scene.settings.sediment.carried = true;
        scene.settings.sediment.settling_m_per_s = 0;
        scene.water = [bed = scene.bed](double x, double y, double) {
            return glm::dvec3(x < 400 && y < 400 ? std::max(0.0, 8 - bed(x, y)) : 0, 0, 0);
        };
        TerrainState start = scene.state();
        const float most = 0.01F;
        start.suspended.assign(scene.grid.count(), glm::vec2(0));
        double before = 0;
        for (std::size_t i = 0; i < scene.grid.count(); ++i) {
            if (i % 160 > 20 && i % 160 < 50) start.suspended[i].x = most * start.water[i].x;
            before += start.suspended[i].x;
        }
        WaterRun run(start, scene.settings);
        double highest = 0;
        double lowest = 0;
        double after = 0;
        for (int step = 0; step < 20; ++step) {
            run.run(0.5, run.time_s() + 3);
            const TerrainState now = run.read();
            after = 0;
            for (std::size_t i = 0; i < scene.grid.count(); ++i) {
                const glm::vec2 load = now.suspended.empty() ? glm::vec2(0) : now.suspended[i];
                after += static_cast<double>(load.x) + load.y;
                lowest = std::min(lowest, static_cast<double>(load.x));
                if (now.water[i].x > 1e-6F)
                    highest = std::max(highest, static_cast<double>(load.x) / now.water[i].x);
            }
        }
        fmt::print("pulse, order {}: concentration {:.3e} to {:.9f} of its first maximum, mass {:+.1e}\n",
                   order, lowest, highest / most, after / before - 1);
        EXPECT_GE(lowest, 0);
        EXPECT_LE(highest / most, 1 + 1e-6) << "a few roundings above is all that floats allow";
        EXPECT_GT(highest / most, 0.3);
        EXPECT_LE(std::abs(after / before - 1), 1e-6);
    }
}

TEST(Sediment, SkippingWhatRestsChangesNothing) {
    const gpu::Context context;
    for (const int order : {1, 2}) {
        // A flood into the corner of a dry map, which leaves its silt behind; and a cloudy pond at rest
        // elsewhere.
        WaterScene scene = eroding_basin(320, 5);
        scene.settings.order = order;
        scene.water = [bed = scene.bed](double x, double y, double) {
            return glm::dvec3(x < 300 && y < 300 ? std::max(0.0, 6 - bed(x, y)) : 0, 0, 0);
        };
        TerrainState start = with_regolith(scene);
        start.suspended.assign(scene.grid.count(), glm::vec2(0));
        for (int row = 40; row < 50; ++row)
            for (int column = 240; column < 250; ++column) {
                const std::size_t at = static_cast<std::size_t>(row) * 320 + column;
                start.water[at].x = 1e-3F;
                start.suspended[at].x = 1e-5F;
            }
        WaterRun sparse(start, scene.settings);
        WaterRun dense(start, scene.settings);
        dense.settings.skips_rest = false;
        for (int i = 0; i < 2; ++i) {
            sparse.run(1, sparse.time_s() + 20);
            dense.run(1, dense.time_s() + 20);
            const TerrainState a = sparse.read();
            const TerrainState b = dense.read();
            ASSERT_EQ(differing(a.water, b.water), 0U);
            ASSERT_EQ(differing(solid_of(a), solid_of(b)), 0U);
            ASSERT_EQ(differing(load_of(a), load_of(b)), 0U);
        }
        EXPECT_LT(sparse.water.work().tiles, dense.water.work().tiles * 8 / 10)
            << "something must have slept";
        EXPECT_GT(differing(solid_of(start), solid_of(sparse.read())), scene.grid.count() / 40);
    }
}

TEST(Sediment, TurnsAndMirrorsToTheBit) {
    const gpu::Context context;
    constexpr int n = 150;
    WaterScene scene = scenes::radial_dam(n, true);
    scene.settings.manning_s_per_m13 = 0.03;
    scene.settings.sediment = silt();
    const TerrainState start = scene.state();
    WaterRun run(start, scene.settings);
    run.run(0.5, 12);
    const TerrainState end = run.read();
    const std::vector<glm::vec4> solid = solid_of(end);
    const std::vector<glm::vec2> load = load_of(end);
    EXPECT_GT(differing(solid, solid_of(start)), scene.grid.count() / 4);
    std::size_t apart = 0;
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            const std::size_t here = static_cast<std::size_t>(y) * n + x;
            const std::size_t west = static_cast<std::size_t>(y) * n + (n - 1 - x);
            const std::size_t from = static_cast<std::size_t>(x) * n + (n - 1 - y);
            apart += solid[here] == solid[west] && load[here] == load[west] ? 0 : 1;
            apart += solid[here] == solid[from] && load[here] == load[from] ? 0 : 1;
        }
    EXPECT_EQ(apart, 0U);
}

}  // namespace
}  // namespace talus::sediment_test

// Erosion by water: exact answers, bounds, conservation, symmetry, skipping, and the twins.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "sim/gpu/context.h"
#include "sim/passes/water_twin.h"
#include "tests/scenes/water_scenes.h"

namespace talus {
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

template <typename Real>
maths::WaterTwin<Real> twin_of(const TerrainState& state, const WaterSettings& settings) {
    std::vector<Real> beds;
    std::vector<glm::vec<4, Real>> water;
    std::vector<glm::vec<4, Real>> solid;
    for (const float height : state.ground()) beds.push_back(height);
    for (const glm::vec4& texel : state.water) water.emplace_back(texel);
    for (const glm::vec4& texel : solid_of(state)) solid.emplace_back(texel);
    std::vector<glm::vec<2, Real>> load;
    for (const glm::vec2& texel : load_of(state)) load.emplace_back(texel);
    maths::WaterTwin<Real> twin(state.grid, beds, water, settings, state.painted);
    twin.carry(solid, load);
    return twin;
}

TEST(Sediment, AgreesWithItsFloatTwinToTheBit) {
    const gpu::Context context;
    struct Case {
        int order;
        double rain;
        EdgeKind north, south, west, east;
    };
    const Case cases[] = {
        {2, 0, EdgeKind::wall, EdgeKind::wall, EdgeKind::wall, EdgeKind::wall},
        {1, 0, EdgeKind::wall, EdgeKind::open, EdgeKind::level, EdgeKind::wall},
        {2, 2e-4, EdgeKind::open, EdgeKind::level, EdgeKind::inflow, EdgeKind::open},
        {2, 0, EdgeKind::periodic, EdgeKind::periodic, EdgeKind::periodic, EdgeKind::periodic},
        {1, 1e-4, EdgeKind::wave, EdgeKind::inflow, EdgeKind::level, EdgeKind::wave}};
    for (const Case& c : cases) {
        WaterScene scene = eroding_basin(97, 2);
        scene.grid.nx = 131;
        scene.grid.dy = 6;
        scene.settings.order = c.order;
        scene.settings.rain_m_per_s = c.rain;
        scene.settings.infiltration_m_per_s = c.rain / 3;
        scene.settings.edges = {c.north, c.south, c.west, c.east};
        scene.settings.level_m = 3;
        scene.settings.wave_height_m = 0.7;
        scene.settings.wave_period_s = 4;
        scene.settings.inflow_m3_per_s = 900;
        scene.settings.sediment.inflow_concentration = 0.002;
        scene.settings.sediment.strata_m = 1;
        scene.settings.sediment.strata_hardness = 0.8;
        TerrainState start = with_regolith(scene);
        for (std::size_t i = 0; i < scene.grid.count(); ++i)
            start.painted.emplace_back(0.01F * static_cast<float>(i % 100), 0, 0, 0);
        WaterRun run(start, scene.settings);
        auto twin = twin_of<float>(start, scene.settings);
        auto exact = twin_of<double>(start, scene.settings);
        for (int tick = 0; tick < 10; ++tick) {
            twin.tick(1, run.time_s());
            exact.tick(1, run.time_s());
            run.tick(1);
        }
        const TerrainState end = run.read();
        EXPECT_EQ(differing(end.water, twin.read()), 0U) << "order " << c.order;
        EXPECT_EQ(differing(solid_of(end), twin.solid()), 0U) << "order " << c.order;
        EXPECT_EQ(differing(load_of(end), twin.read_load()), 0U) << "order " << c.order;
        EXPECT_GT(differing(solid_of(end), solid_of(start)), scene.grid.count() / 8);
        double missed = 0;
        double moved = 0;
        const auto height = [](const glm::dvec4& words) { return words.x + words.y + words.z + words.w; };
        const std::vector<glm::vec4> before = solid_of(start);
        const std::vector<glm::vec4> after = solid_of(end);
        for (std::size_t i = 0; i < scene.grid.count(); ++i) {
            missed += std::abs(height(after[i]) - height(exact.solid()[i]));
            moved += std::abs(height(exact.solid()[i]) - height(before[i]));
        }
        fmt::print("sediment, float against double, order {}: L1 of the change of the ground {:.1e}\n",
                   c.order, missed / moved);
        EXPECT_LT(missed / moved, 1e-3);
    }
}

}  // namespace
}  // namespace talus

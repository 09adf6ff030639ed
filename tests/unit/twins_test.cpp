// Brush and thermal erosion agree with their float twins bit for bit, where the device rounds as they do (law
// 4).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <random>

#include "app/claims/arithmetic.h"
#include "app/claims/twin_agreement.h"
#include "sim/gpu/context.h"
#include "sim/passes/brush.h"
#include "sim/passes/brush_twin.h"
#include "sim/terrain/generate.h"

namespace talus::twins_test {
namespace {

std::vector<glm::vec4> samples_of(const TerrainState& state) {
    std::vector<glm::vec4> samples;
    samples.reserve(state.bedrock.size());
    for (std::size_t i = 0; i < state.bedrock.size(); ++i)
        samples.emplace_back(state.bedrock[i], state.regolith[i]);
    return samples;
}

std::size_t differing(const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (int k = 0; k < 4; ++k)
            if (std::bit_cast<std::uint32_t>(a[i][k]) != std::bit_cast<std::uint32_t>(b[i][k])) {
                ++count;
                break;
            }
    return count;
}

// Software rounds as the twins do. Where a device does not, tests of bits say nothing, and the double twin
// binds.
TEST(Twins, DevicesRoundAsPromised) {
    const gpu::Context context;
    const claims::Arithmetic arithmetic = claims::arithmetic_of_device();
    fmt::print("{}\n", claims::describe(arithmetic));
    if (context.device().software) {
        EXPECT_TRUE(arithmetic.rounds_as_ieee());
    }
    // Sums and products round exactly everywhere, chained ones too: `precise` keeps them apart.
    EXPECT_EQ(arithmetic.of("+").differing, 0);
    EXPECT_EQ(arithmetic.of("×").differing, 0);
    EXPECT_EQ(arithmetic.of("× +").differing, 0);
    // OpenGL allows a quotient 2.5 units of the last digit, and a root what 1/inversesqrt may miss: 2 more.
    EXPECT_LE(arithmetic.of("÷").worst_ulp, 2.5);
    EXPECT_LE(arithmetic.of("√").worst_ulp, 4.5);
}

TEST(Twins, BrushAndThermalAgreeToTheBitAfter500Ticks) {
    const gpu::Context context;
    const claims::TwinAgreement agreement = claims::brush_and_slopes_against_twin(500);
    if (claims::arithmetic_of_device().rounds_as_ieee()) {
        EXPECT_EQ(agreement.differing, 0U);
    }
    EXPECT_GT(agreement.changed, agreement.samples / 2) << "the run must have moved the ground";
    EXPECT_LT(agreement.of_double, 1e-4);
}

TEST(Twins, SlopesByOlsenAgreeToTheBit) {
    const gpu::Context context;
    for (const ThermalScheme scheme : {ThermalScheme::olsen, ThermalScheme::olsen_fast}) {
        const claims::TwinAgreement agreement = claims::brush_and_slopes_against_twin(100, scheme);
        if (claims::arithmetic_of_device().rounds_as_ieee()) {
            EXPECT_EQ(agreement.differing, 0U);
        }
        EXPECT_GT(agreement.changed, agreement.samples / 2) << "the run must have moved the ground";
    }
}

// Dabs of several kinds, modes and curves in turn agree with the float twin to the bit. On Mesa 22.3's zink
// they did not: programs that take turns got each other's variants of inlined uniforms (work_around_drivers,
// docs/devices.md).
// Over the map, in and out of the ground.
PathDab some_path(const Grid& grid, std::mt19937& random) {
    std::uniform_real_distribution<double> unit(0, 1);
    PathDab path;
    path.points_m.clear();
    const auto points = 2 + random() % 5;
    for (std::size_t i = 0; i < points; ++i)
        path.points_m.emplace_back(unit(random) * grid.width_m(), unit(random) * grid.height_m(),
                                   900 * unit(random));
    path.half_width_m = 60 * unit(random);
    path.cut_slope = 0.2 + unit(random);
    path.fill_slope = 0.2 + unit(random);
    path.cuts = random() % 4 != 0;
    path.fills = random() % 4 != 0;
    return path;
}

TEST(TwinsInTurn, AgreeToTheBit) {
    const gpu::Context context;
    if (!claims::arithmetic_of_device().rounds_as_ieee())
        GTEST_SKIP() << claims::describe(claims::arithmetic_of_device());
    const Grid grid{71, 57, 28, 37};
    TerrainState state = bedrock_terrain(grid, generate_heights(grid, {"mountains", 7, 900}));
    maths::BrushTwin<float> twin;
    twin.nx = grid.nx;
    twin.ny = grid.ny;
    for (std::size_t i = 0; i < grid.count(); ++i) {
        const float mask = 0.25F * static_cast<float>(i % 5);
        state.painted.emplace_back(0, mask, 0, 0);
        twin.masks.push_back(mask);
    }
    Terrain terrain(state);
    Brush brush(terrain);
    twin.ground_samples = samples_of(state);
    std::mt19937 random(42);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int i = 0; i < 400; ++i) {
        // Terrains that take each other's place bring programs of their own.
        if (i % 20 == 19) brush = Brush(terrain);
        Dab dab;
        dab.effect = effect_of(static_cast<BrushMode>(random() % 7));
        if (i % 5 == 0) dab.effect = some_path(grid, random);
        dab.curve = static_cast<FalloffCurve>(random() % 4);
        dab.masked = random() % 2 == 0;
        if (auto* ramp = dab.as<RampDab>())
            *ramp = {900.0 * (glm::dvec2(unit(random), unit(random)) - 0.5), 100 * (unit(random) - 0.5)};
        if (auto* terrace = dab.as<TerraceDab>()) terrace->step_m = 40;
        dab.x_m = unit(random) * grid.width_m();
        dab.y_m = unit(random) * grid.height_m();
        dab.radius_m = 40 + 500 * unit(random);
        dab.falloff = unit(random);
        dab.amount_m = 5;
        dab.blend = unit(random);
        dab.target_m = 900 * unit(random);
        dab.material = random() % 2 == 0 ? Material::regolith : Material::bedrock;
        brush.dab(terrain, dab);
        if (dab.as<PathDab>()) twin.path = path_line(dab);
        twin.dab(dab.mode(), dab_numbers(grid, dab));
        if (i % 10 == 9) {
            ASSERT_EQ(differing(samples_of(terrain.read()), twin.ground_samples), 0U) << "up to dab " << i;
        }
    }
}

}  // namespace
}  // namespace talus::twins_test

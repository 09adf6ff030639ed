// Brush and thermal erosion agree with their float twins bit for bit (law 4).
#include <gtest/gtest.h>

#include <bit>
#include <random>

#include "sim/gpu/context.h"
#include "sim/passes/brush_twin.h"
#include "sim/passes/thermal.h"
#include "sim/passes/thermal_twin.h"
#include "sim/terrain/generate.h"

namespace talus {
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

TEST(Twins, BrushAndThermalAgreeToTheBitAfter500Ticks) {
    const gpu::Context context;
    const Grid grid{150, 97, 20, 17};
    TerrainState state = bedrock_terrain(grid, generate_heights(grid, {"mountains", 7, 1500}));
    ThermalSettings settings{33, natural_thermal_rate(grid, 1, 0.3)};
    settings.bedrock_deg = 41;
    settings.porosity = 0.3;
    settings.weathering_m_per_s = 1e-4;
    settings.masked = true;
    const ThermalStep step = thermal_step(grid, settings, 1, 1);
    maths::ThermalTwin<float> thermal_twin(grid, step);
    for (std::size_t i = 0; i < grid.count(); ++i) {
        const float mask = i % 5 == 0 ? 0.0F : 0.25F * static_cast<float>(i % 5);
        state.painted.emplace_back(0, mask, 0, 0);
        thermal_twin.masks.push_back(mask);
    }
    Terrain terrain(state);
    Thermal thermal(terrain);
    Brush brush(terrain);
    maths::BrushTwin<float> brush_twin;
    brush_twin.nx = grid.nx;
    brush_twin.ny = grid.ny;
    brush_twin.masks = thermal_twin.masks;
    const glm::ivec2 stamp_samples(9, 7);
    brush_twin.stamp_samples = stamp_samples;
    for (int i = 0; i < 63; ++i) brush_twin.stamp_heights.push_back(static_cast<float>(i * 37 % 63) / 62);
    gpu::Texture stamp("stamp", gpu::Format::r32f, stamp_samples.x, stamp_samples.y);
    stamp.write(stamp.whole(), std::as_bytes(std::span(brush_twin.stamp_heights)));
    std::vector<glm::vec4> samples = samples_of(state);
    std::mt19937 random(42);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int tick = 0; tick < 500; ++tick) {
        if (tick % 5 == 0) {
            Dab dab;
            dab.mode = static_cast<BrushMode>(tick / 5 % 8);
            dab.curve = static_cast<FalloffCurve>(tick / 40 % 4);
            dab.masked = tick / 5 % 3 == 0;
            if (dab.mode == BrushMode::ramp)
                dab.way_m = 900.0 * (glm::dvec2(unit(random), unit(random)) - 0.5);
            dab.rise_m = 300 * (unit(random) - 0.5);
            dab.step_m = 10 + 90 * unit(random);
            dab.flat = 0.9 * unit(random);
            dab.noise = {tick / 40 % 3, 40 + 400 * unit(random), 1 + tick / 40 % 6,
                         0.5,           tick / 40 % 2 * 0.3,     static_cast<std::uint32_t>(tick)};
            dab.stamp = {static_cast<StampMode>(tick / 40 % 4),
                         {50 + 400 * unit(random), 300},
                         360 * unit(random),
                         tick % 10 == 0,
                         0.3 * (tick / 80 % 3)};
            dab.x_m = unit(random) * grid.width_m();
            dab.y_m = unit(random) * grid.height_m();
            dab.radius_m = 40 + 600 * unit(random);
            dab.falloff = unit(random);
            dab.amount_m = 30 * unit(random);
            dab.blend = unit(random);
            dab.target_m = 1500 * unit(random);
            dab.material = unit(random) < 0.5 ? Material::regolith : Material::bedrock;
            brush.dab(terrain, dab, &stamp);
            brush_twin.ground_samples.swap(samples);
            brush_twin.dab(dab, dab_step(grid, dab, stamp_samples));
            brush_twin.ground_samples.swap(samples);
        }
        thermal.substep(terrain, step);
        thermal_twin.samples.swap(samples);
        thermal_twin.step();
        thermal_twin.samples.swap(samples);
    }
    const TerrainState after = terrain.read();
    EXPECT_EQ(differing(samples_of(after), samples), 0U);
    EXPECT_GT(differing(samples_of(after), samples_of(state)), grid.count() / 2)
        << "the run must have moved the ground";
    EXPECT_EQ(terrain.ground.read_all<float>(), after.ground());
}

// Dabs of several kinds, modes and curves in turn agree with the float twin to the bit. On Mesa 22.3's zink
// they did not: programs that take turns got each other's variants of inlined uniforms (work_around_drivers).
TEST(Twins, DabsOfAllKindsInTurnAgreeToTheBit) {
    const gpu::Context context;
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
        dab.mode = static_cast<BrushMode>(random() % 7);
        dab.curve = static_cast<FalloffCurve>(random() % 4);
        dab.masked = random() % 2 == 0;
        dab.way_m = 900.0 * (glm::dvec2(unit(random), unit(random)) - 0.5);
        dab.rise_m = 100 * (unit(random) - 0.5);
        dab.step_m = 40;
        dab.x_m = unit(random) * grid.width_m();
        dab.y_m = unit(random) * grid.height_m();
        dab.radius_m = 40 + 500 * unit(random);
        dab.falloff = unit(random);
        dab.amount_m = 5;
        dab.blend = unit(random);
        dab.target_m = 900 * unit(random);
        dab.material = random() % 2 == 0 ? Material::regolith : Material::bedrock;
        brush.dab(terrain, dab);
        twin.dab(dab, dab_step(grid, dab));
        if (i % 10 == 9) {
            ASSERT_EQ(differing(samples_of(terrain.read()), twin.ground_samples), 0U) << "up to dab " << i;
        }
    }
}

}  // namespace
}  // namespace talus

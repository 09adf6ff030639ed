#include "app/claims/twin_agreement.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "app/claims/differing_bits.h"
#include "app/claims/water_scenes.h"
#include "sim/passes/brush.h"
#include "sim/passes/brush_twin.h"
#include "sim/passes/thermal.h"
#include "sim/passes/thermal_twin.h"
#include "sim/passes/water_twin.h"
#include "sim/terrain/bed_beyond.h"
#include "sim/terrain/generate.h"

namespace talus::claims {

using scenes::WaterRun;
using scenes::WaterScene;

namespace {

std::vector<glm::vec4> solid_of(const TerrainState& state) {
    std::vector<glm::vec4> solid;
    solid.reserve(state.bedrock.size());
    for (std::size_t i = 0; i < state.bedrock.size(); ++i)
        solid.emplace_back(state.bedrock[i], state.regolith[i]);
    return solid;
}

double height_of(const glm::dvec4& words) {
    return words.x + words.y + words.z + words.w;
}

// Σ|found - exact| over Σ|exact - start| of the ground.
template <typename Exact>
double l1_of_moved(const std::vector<glm::vec4>& start, const std::vector<glm::vec4>& found,
                   const Exact& exact) {
    double missed = 0;
    double moved = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const double wanted = height_of(glm::dvec4(exact[i]));
        missed += std::abs(height_of(found[i]) - wanted);
        moved += std::abs(wanted - height_of(start[i]));
    }
    return missed / moved;
}

// The twins of brush and slopes, over the same samples.
template <typename Real>
struct SolidTwin {
    maths::BrushTwin<Real> brush;
    maths::ThermalTwin<Real> thermal;
    std::vector<glm::vec<4, Real>> samples;

    SolidTwin(const TerrainState& state, const ThermalStep& step) : thermal(state.grid, step) {
        brush.nx = state.grid.nx;
        brush.ny = state.grid.ny;
        for (const glm::vec4& painted : state.painted) thermal.masks.push_back(painted.y);
        brush.masks = thermal.masks;
        for (const glm::vec4& solid : solid_of(state)) samples.emplace_back(solid);
        brush.worn = thermal.worn = std::vector<glm::vec<4, Real>>(samples.size(), glm::vec<4, Real>(0));
    }
    void dab(const Dab& dab, const DabNumbers& numbers) {
        if (dab.as<PathDab>()) brush.path = path_line(dab);
        brush.ground_samples.swap(samples);
        brush.dab(dab.mode(), numbers);
        brush.ground_samples.swap(samples);
    }
    void slide() {
        thermal.samples.swap(samples);
        thermal.step();
        thermal.samples.swap(samples);
    }
};

constexpr glm::ivec2 stamp_samples(9, 7);

// The dab of a sub-step: all modes, curves and materials come in turn.
Dab turning_dab(int substep, const Grid& grid, std::mt19937& random) {
    std::uniform_real_distribution<double> unit(0, 1);
    Dab dab;
    dab.curve = static_cast<FalloffCurve>(substep / 40 % 4);
    dab.masked = substep / 5 % 3 == 0;
    const int turn = substep / 5 % 9;
    dab.effect = turn < 8 ? effect_of(static_cast<BrushMode>(turn)) : DabEffect(PathDab());
    if (auto* path = dab.as<PathDab>()) {
        path->points_m.clear();
        for (int i = 0; i < 3; ++i)
            path->points_m.emplace_back(unit(random) * grid.width_m(), unit(random) * grid.height_m(),
                                        1500 * unit(random));
        path->half_width_m = 60;
    }
    if (auto* ramp = dab.as<RampDab>())
        *ramp = {900.0 * (glm::dvec2(unit(random), unit(random)) - 0.5), 300 * (unit(random) - 0.5)};
    if (auto* terrace = dab.as<TerraceDab>()) *terrace = {10 + 90 * unit(random), 0.9 * unit(random)};
    if (auto* noise = dab.as<NoiseDab>())
        *noise = {substep / 40 % 3,       40 + 400 * unit(random),
                  1 + substep / 40 % 6,   0.5,
                  substep / 40 % 2 * 0.3, static_cast<std::uint32_t>(substep)};
    if (auto* stamp = dab.as<StampDab>())
        *stamp = {static_cast<StampMode>(substep / 40 % 4),
                  {50 + 400 * unit(random), 300},
                  360 * unit(random),
                  substep % 10 == 0,
                  0.3 * (substep / 80 % 3)};
    dab.x_m = unit(random) * grid.width_m();
    dab.y_m = unit(random) * grid.height_m();
    dab.radius_m = 40 + 600 * unit(random);
    dab.falloff = unit(random);
    dab.amount_m = 30 * unit(random);
    dab.blend = unit(random);
    dab.target_m = 1500 * unit(random);
    dab.material = unit(random) < 0.5 ? Material::regolith : Material::bedrock;
    return dab;
}

template <typename Real>
maths::WaterTwin<Real> water_twin(const TerrainState& state, const WaterSettings& settings) {
    std::vector<Real> beds;
    std::vector<glm::vec<4, Real>> water;
    for (const float height : state.ground()) beds.push_back(height);
    for (const glm::vec4& texel : state.water) water.emplace_back(texel);
    maths::WaterTwin<Real> twin(state.grid, beds, water, settings, state.painted, state.springs,
                                state.bed_beyond);
    if (settings.sediment.carried) {
        std::vector<glm::vec<4, Real>> solid;
        for (const glm::vec4& texel : solid_of(state)) solid.emplace_back(texel);
        twin.carry(solid, std::vector<glm::vec<2, Real>>(state.grid.count(), glm::vec<2, Real>(0)));
    }
    twin.cover_land(state.land_cover);
    twin.count_maps();
    return twin;
}

// What both kinds of water have in common.
WaterScene sloshing(const WaterCase& c) {
    WaterScene scene = scenes::basin(97, 2);
    scene.grid.nx = 131;
    scene.grid.dy = 6;
    scene.settings.order = c.order;
    scene.settings.manning_s_per_m13 = c.manning_s_per_m13;
    scene.settings.rain_m_per_s = c.rain_m_per_s;
    scene.settings.infiltration_m_per_s = c.rain_m_per_s / 3;
    scene.settings.edges = {c.north, c.south, c.west, c.east};
    scene.knows_bed_beyond = c.knows_bed_beyond;
    scene.settings.has_sea = c.order == 2;
    scene.settings.level_m = 3;
    scene.settings.wave_height_m = 0.7;
    scene.settings.wave_period_s = 4;
    scene.settings.inflow_m3_per_s = 900;
    scene.settings.counts_maps = true;
    if (c.driven) {
        scene.settings.wave_form = WaveForm::series;
        scene.settings.driven = {TimeSeries({{0, 400}, {3.3, 0}, {4.1, 0}, {9, 900}}),
                                 TimeSeries({{0, 0}, {2.5, 1400}, {2.5, 300}, {7, 0}, {8, 700}}),
                                 TimeSeries({{0, 3}, {4, 4.5}, {9.7, 2}}),
                                 TimeSeries({{0, 0}, {1, 0.6}, {2.2, -0.5}, {3, 0.2}, {8, 0}}), 0};
    }
    return scene;
}

// Roughness and infiltration of every share, and none in places.
void cover_land(TerrainState& state, WaterSettings& settings) {
    settings.manning_painted = settings.infiltration_painted = true;
    for (std::size_t i = 0; i < state.grid.count(); ++i) {
        const float rough = 0.25F * static_cast<float>(i % 5);
        const float soaked = 0.5F * static_cast<float>(i / 3 % 3);
        state.land_cover.emplace_back(0.01F * rough * static_cast<float>(i % 11), rough,
                                      soaked * static_cast<float>(i % 7) * 900, soaked);
    }
}

// In stretches of each edge, of both ghosts, of the further one or of the nearer one.
void forget_some_bed_beyond(TerrainState& state) {
    for (std::size_t i = 0; i < state.bed_beyond.size(); ++i)
        if (i / 2 % 16 < 4 || i / 2 % 16 / 3 == (i % 2 == 1 ? 2 : 3)) state.bed_beyond[i] = glsl::unknown_bed;
}

// Ten ticks of the device and of both twins.
template <typename Act>
void run_with_twins(WaterRun& run, maths::WaterTwin<float>& twin, maths::WaterTwin<double>& exact,
                    Act&& after) {
    for (int tick = 0; tick < 10; ++tick) {
        twin.tick(1, run.time_s());
        exact.tick(1, run.time_s());
        run.tick(1);
    }
    after(run.read());
}

}  // namespace

TwinAgreement brush_and_slopes_against_twin(int substeps, ThermalScheme scheme) {
    const Grid grid{150, 97, 20, 17};
    TerrainState state = bedrock_terrain(grid, generate_heights(grid, {"mountains", 7, 1500}));
    for (std::size_t i = 0; i < grid.count(); ++i)
        state.painted.emplace_back(0, i % 5 == 0 ? 0.0F : 0.25F * static_cast<float>(i % 5), 0, 0);
    ThermalSettings settings{33, natural_thermal_rate(grid, 1, 0.3)};
    settings.bedrock_deg = 41;
    settings.porosity = 0.3;
    settings.weathering_m_per_s = 1e-4;
    settings.masked = true;
    settings.scheme = scheme;
    ThermalStep step = thermal_step(grid, settings, 1, 1);
    step.counts_wear = true;
    SolidTwin<float> twin(state, step);
    SolidTwin<double> exact(state, step);
    for (int i = 0; i < 63; ++i) twin.brush.stamp_heights.push_back(static_cast<float>(i * 37 % 63) / 62);
    exact.brush.stamp_heights.assign(twin.brush.stamp_heights.begin(), twin.brush.stamp_heights.end());
    gpu::Texture stamp("stamp", gpu::Format::r32f, stamp_samples.x, stamp_samples.y);
    stamp.write(stamp.whole(), std::as_bytes(std::span(twin.brush.stamp_heights)));
    Terrain terrain(state);
    Thermal thermal(terrain);
    terrain.add(&Terrain::worn_by_slopes);
    Brush brush(terrain);
    brush.count_wear(true);
    std::mt19937 random(42);
    for (int substep = 0; substep < substeps; ++substep) {
        if (substep % 5 == 0) {
            const Dab dab = turning_dab(substep, grid, random);
            const DabNumbers numbers = dab_numbers(grid, dab, stamp_samples);
            brush.dab(terrain, dab, &stamp);
            twin.dab(dab, numbers);
            exact.dab(dab, numbers);
        }
        thermal.substep(terrain, step);
        twin.slide();
        exact.slide();
    }
    const std::vector<glm::vec4> start = solid_of(state);
    const TerrainState ended = terrain.read();
    const std::vector<glm::vec4> end = solid_of(ended);
    return {
        std::max({differing_bits(end, twin.samples), differing_bits(ended.worn_by_slopes, twin.thermal.worn),
                  differing_bits(ended.worn_by_hand, twin.brush.worn)}),
        differing_bits(end, start), grid.count(), l1_of_moved(start, end, exact.samples)};
}

TwinAgreement water_against_twin(const WaterCase& c) {
    WaterScene scene = sloshing(c);
    scene.settings.inflow_rise_s = 6;
    TerrainState start = scene.state();
    forget_some_bed_beyond(start);
    if (c.manning_s_per_m13 > 0) {  // rain, roughness and infiltration by maps
        cover_land(start, scene.settings);
        scene.settings.inflow_by_conveyance = true;
        scene.settings.rain_painted = scene.settings.rain_masked = true;
        for (std::size_t i = 0; i < start.grid.count(); ++i)
            start.painted.emplace_back(0, 0.01F * static_cast<float>(i % 100), i % 7 * 100, 0);
    }
    start.springs = {{123, 77, 20}, {125, 77, 7}, {5, 400, 300}};  // two in one sample
    WaterRun run(start, scene.settings);
    run.springs = start.springs;
    auto twin = water_twin<float>(start, scene.settings);
    auto exact = water_twin<double>(start, scene.settings);
    TwinAgreement agreement;
    run_with_twins(run, twin, exact, [&](const TerrainState& end) {
        double missed = 0;
        double all = 0;
        const std::vector<glm::dvec4> in_double = exact.read();
        for (std::size_t i = 0; i < end.water.size(); ++i) {
            missed += std::abs(static_cast<double>(end.water[i].x) - in_double[i].x);
            all += in_double[i].x;
        }
        agreement = {std::max(differing_bits(end.water, twin.read()), differing_bits(end.flow, twin.flow())),
                     differing_bits(end.water, start.water), end.water.size(), missed / all};
    });
    return agreement;
}

TwinAgreement sediment_against_twin(const WaterCase& c) {
    WaterCase rough = c;
    rough.manning_s_per_m13 = 0.03;
    WaterScene scene = sloshing(rough);
    // Coarse silt in a stream that carries much: all parts of the exchange act.
    SedimentSettings& silt = scene.settings.sediment;
    silt.carried = true;
    silt.regolith_m_per_s_pa = 4e-6;
    silt.bedrock_m_per_s_pa = 4e-7;
    silt.critical_pa = 2;
    silt.settling_m_per_s = 0.02;
    silt.porosity = 0.3;
    silt.acceleration = 20;
    silt.inflow_concentration = 0.002;
    silt.strata_m = 1;
    silt.strata_hardness = 0.8;
    silt.masked = c.order == 1;
    TerrainState start = scene.state();
    forget_some_bed_beyond(start);
    for (std::size_t i = 0; i < scene.grid.count(); ++i) {
        // Regolith of varied depth, bare in places, and hardness painted.
        const auto x = static_cast<float>(i % static_cast<std::size_t>(scene.grid.nx));
        const float depth = std::max(0.0F, 0.02F * std::sin(0.2F * x) + 0.005F);
        start.regolith[i].x = depth;
        start.bedrock[i].x -= depth;
        start.painted.emplace_back(0.01F * static_cast<float>(i % 100), 0.05F * static_cast<float>(i % 21), 0,
                                   0);
    }
    if (c.order == 2) cover_land(start, scene.settings);
    start.springs = {{123, 77, 20}, {125, 77, 7}, {5, 400, 300}};  // two in one sample
    WaterRun run(start, scene.settings);
    run.springs = start.springs;
    auto twin = water_twin<float>(start, scene.settings);
    auto exact = water_twin<double>(start, scene.settings);
    TwinAgreement agreement;
    run_with_twins(run, twin, exact, [&](const TerrainState& end) {
        const std::vector<glm::vec4> before = solid_of(start);
        const std::vector<glm::vec4> after = solid_of(end);
        agreement = {
            std::max({differing_bits(end.water, twin.read()), differing_bits(after, twin.solid()),
                      differing_bits(end.suspended, twin.read_load()), differing_bits(end.flow, twin.flow()),
                      differing_bits(end.worn_by_water, twin.worn())}),
            differing_bits(after, before), scene.grid.count(), l1_of_moved(before, after, exact.solid())};
    });
    return agreement;
}

}  // namespace talus::claims

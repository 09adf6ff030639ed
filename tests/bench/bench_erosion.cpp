// What erosion costs beside the water alone, where little of the map is active, and on a field of 4096²; and
// its error against run time.
#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "app/claims/exact_solutions.h"
#include "app/claims/water_scenes.h"
#include "app/core/report.h"
#include "render/renderer.h"
#include "sim/passes/thermal.h"
#include "sim/passes/water_twin.h"
#include "sim/simulation.h"
#include "sim/simulation_parameters.h"
#include "sim/terrain/generate.h"
#include "tests/bench/measure.h"

namespace talus::bench {

namespace {

constexpr int tick_samples = 1024;

// Hills under a running sheet of water, on all of the map or on a strip of that share.
std::unique_ptr<Simulation> hills(bool erodes, double share) {
    const Grid grid{tick_samples, tick_samples, 10, 10};
    TerrainState state = bedrock_terrain(grid, generate_heights(grid, {"hills", 3, 900}));
    state.water.assign(grid.count(), glm::vec4(0));
    for (std::size_t i = 0; i < grid.count(); ++i) {
        const bool inside = static_cast<double>(i % tick_samples) < share * tick_samples;
        // Beyond the strip a plateau stays dry.
        if (!inside) state.bedrock[i].x = 2000;
        if (inside) state.water[i].x = 0.5F;
    }
    Parameters all(simulation_parameters());
    for (const char* assignment :
         {"time.tick_s=0.5", "water.manning=0.04", "water.boundary.north=wall", "water.boundary.south=wall",
          "water.boundary.west=wall", "water.boundary.east=wall", "thermal.repose_deg=20",
          "thermal.bedrock_deg=89", "thermal.rate_m2_per_s=20", "erosion.erodibility=5",
          "erosion.bedrock_erodibility=1", "erosion.critical_shear_pa=5", "erosion.porosity=0.3",
          "erosion.acceleration=10"})
        all.set_assignment(assignment);
    all.set("erosion.on", erodes);
    all.set("thermal.on", erodes);
    auto simulation = std::make_unique<Simulation>(state, all);
    simulation->apply(Ticks{4});
    return simulation;
}

// A cloudburst over hills of 1.6 km, which it carves for two minutes.
scenes::WaterScene carved(int samples) {
    scenes::WaterScene scene;
    scene.grid = {samples, samples, 1600.0 / samples, 1600.0 / samples};
    scene.settings.manning_s_per_m13 = 0.04;
    scene.settings.sediment.carried = true;
    scene.settings.sediment.regolith_m_per_s_pa = 5e-6;
    scene.settings.sediment.bedrock_m_per_s_pa = 1e-6;
    scene.settings.sediment.critical_pa = 5;
    scene.settings.sediment.settling_m_per_s = 0.02;
    scene.settings.sediment.porosity = 0.3;
    scene.settings.sediment.acceleration = 20;
    scene.bed = [](double x, double y) {
        return 60 * std::sin(x / 240) * std::cos(y / 310) + 20 * std::sin((x + 2 * y) / 130) +
               6 * std::cos((2 * x - y) / 61);
    };
    scene.water = [](double, double, double) { return glm::dvec3(0.3, 0, 0); };
    return scene;
}

// What the ground gained, as means over 50 x 50 squares.
template <typename Solid>
std::vector<double> gained(const std::vector<Solid>& before, const std::vector<Solid>& after, int samples) {
    const int share = samples / 50;
    std::vector<double> means(2500, 0.0);
    for (int y = 0; y < samples; ++y)
        for (int x = 0; x < samples; ++x) {
            const std::size_t i = static_cast<std::size_t>(y) * samples + x;
            double gain = 0;
            for (int word = 0; word < 4; ++word)
                gain += static_cast<double>(after[i][word]) - static_cast<double>(before[i][word]);
            means[static_cast<std::size_t>(y / share) * 50 + x / share] += gain / (share * share);
        }
    return means;
}

std::vector<glm::vec4> solid_of(const TerrainState& state) {
    std::vector<glm::vec4> solid;
    solid.reserve(state.bedrock.size());
    for (std::size_t i = 0; i < state.bedrock.size(); ++i)
        solid.emplace_back(state.bedrock[i], state.regolith[i]);
    return solid;
}

// Against the double twin on the finest grid, in its shortest ticks.
void error_against_time() {
    constexpr double end_s = 60;
    constexpr int finest = 200;
    const scenes::WaterScene fine = carved(finest);
    const TerrainState start = fine.state();
    std::vector<double> beds;
    for (const float height : start.ground()) beds.push_back(height);
    std::vector<glm::dvec4> water(start.water.begin(), start.water.end());
    std::vector<glm::dvec4> solid;
    for (const glm::vec4& texel : solid_of(start)) solid.emplace_back(texel);
    maths::WaterTwin<double> twin(fine.grid, beds, water, fine.settings);
    twin.carry(solid, std::vector<glm::dvec2>(solid.size(), glm::dvec2(0)));
    const double twin_start = app::process_cpu_s();
    for (int tick = 0; tick < 4 * static_cast<int>(end_s); ++tick) twin.tick(0.25, 0.25 * tick);
    fmt::print(
        "\nerror against run time: relative L1 of what the ground gained, against the double twin ({}², "
        "{:.0f} CPU s)\n",
        finest, app::process_cpu_s() - twin_start);
    fmt::print("scene\ttick_s\tn\terror\trun_time_s\tsubsteps\n");
    const std::vector<double> exact = gained(solid, twin.solid(), finest);
    double all = 0;
    for (const double gain : exact) all += std::abs(gain);
    for (const double tick_s : {0.25, 1.0, 4.0, 20.0})
        for (const int samples : {50, 100, 200}) {
            const scenes::WaterScene scene = carved(samples);
            const TerrainState before = scene.state();
            scenes::WaterRun run(before, scene.settings);
            const double start_s = run_time_s();
            run.run(tick_s, end_s);
            const double run_s = run_time_s() - start_s;
            const std::vector<double> found = gained(solid_of(before), solid_of(run.read()), samples);
            double missed = 0;
            for (std::size_t i = 0; i < found.size(); ++i) missed += std::abs(found[i] - exact[i]);
            fmt::print("hills\t{}\t{}\t{:.3e}\t{:.3f}\t{}\n", tick_s, samples, missed / all, run_s,
                       run.water.work().substeps);
        }
}

// Slopes by the gradient and as Olsen 2004 has them, the erosion of Ammann 2010, figure 10: time of a
// sub-step of 1024² samples that all slide, and the cone that a column of 60 m collapses into.
void schemes_of_slopes() {
    constexpr int side = 1024;
    const Grid grid{side, side, 10, 10};
    Terrain terrain(bedrock_terrain(grid, generate_heights(grid, {"mountains", 4, 4000})));
    Thermal thermal(terrain);
    const std::vector<std::pair<std::string, ThermalScheme>> schemes = {
        {"gradient", ThermalScheme::gradient},
        {"olsen", ThermalScheme::olsen},
        {"olsen_fast", ThermalScheme::olsen_fast}};
    std::vector<Contestant> contestants;
    contestants.reserve(schemes.size());
    for (const auto& [name, scheme] : schemes)
        contestants.push_back({name, [&, scheme = scheme] {
                                   ThermalSettings settings{10, natural_thermal_rate(grid, 1)};
                                   settings.scheme = scheme;
                                   terrain.tiles.mark_all();
                                   thermal.substep(terrain, thermal_step(grid, settings, 1, 1));
                                   terrain.ground.read_all<float>();
                               }});
    const std::vector<double> seconds = interleave(contestants, 5);
    fmt::print("\nslopes by scheme, {}²\n{:<12} {:>12} {:>10} {:>12} {:>12} {:>12} {:>14}\n", side, "scheme",
               "ms/sub-step", "steepest", "axis m", "diagonal m", "exact m", "ledger/moved");
    for (std::size_t i = 0; i < schemes.size(); ++i) {
        const claims::ConeError cone = claims::collapsed_column(129, 11, 60, schemes[i].second);
        fmt::print("{:<12} {:>12.1f} {:>10.2f} {:>12.2f} {:>12.2f} {:>12.2f} {:>14.1e}\n", schemes[i].first,
                   1e3 * seconds[i], cone.steepest_deg, cone.axis_m, cone.diagonal_m, cone.exact_m,
                   cone.ledger_of_moved);
    }
}

// As Ammann, Genevaux & Dischler 2010, figure 11: frames over a field of 4096² at rest, and after every
// height was updated (there every 100 ms; one update takes longer here, so every frame has one).
void large_field(double patch_pixels) {
    constexpr int side = 4096;
    const Grid grid{side, side, 10, 10};
    TerrainState state = bedrock_terrain(grid, generate_heights(grid, {"mountains", 4, 4000}));
    const double e = grid.width_m();
    const render::Camera camera{{0.15 * e, 0.1 * e, 6000}, {0.55 * e, 0.6 * e, 1200}, 55};
    const auto frame = [&](render::Renderer& renderer, Terrain& terrain, bool changed) {
        if (changed)
            terrain.tiles.mark_all();
        else
            renderer.forget();
        renderer.draw(terrain, camera, {}, 1280, 720);
        const std::vector<std::uint8_t> wait = renderer.read_rgb(1, 1);
    };
    fmt::print("\n4096², 1280 x 720, ms\n");
    const auto measure = [&](const char* name, Terrain& terrain, const std::function<void()>& update) {
        render::Renderer renderer(terrain, patch_pixels);
        const std::vector<double>
            seconds =  // A frame at rest follows one that has refreshed what the update changed.
            interleave({{"update", update},
                        {"changed", [&] { frame(renderer, terrain, true); }},
                        {"rest", [&] { frame(renderer, terrain, false); }}},
                       3);
        const double update_ms = 1e3 * seconds[0];
        const double changed_ms = 1e3 * seconds[1];
        const double rest_ms = 1e3 * seconds[2];
        fmt::print(
            "{:<18} frame at rest {:.0f}, with refresh {:.0f} (refresh {:.0f}), update of all heights "
            "{:.0f}: "
            "refresh is {:.1f} % of a frame with update\n",
            name, rest_ms, changed_ms, changed_ms - rest_ms, update_ms,
            100 * (changed_ms - rest_ms) / (changed_ms + update_ms));
    };
    {
        Terrain terrain(state);
        Thermal thermal(terrain);
        const ThermalStep step = thermal_step(grid, {20, natural_thermal_rate(grid, 1)}, 1, 1);
        measure("slopes slide", terrain, [&] {
            terrain.tiles.mark_all();
            thermal.substep(terrain, step);
        });
    }
    state.water.assign(grid.count(), glm::vec4(0));
    for (std::size_t i = 0; i < grid.count(); ++i) {
        state.bedrock[i].x *= 0.02F;
        state.water[i].x = 100 - state.bedrock[i].x + 0.5F * std::sin(0.05F * static_cast<float>(i % side));
    }
    scenes::WaterRun run(state, scenes::scene_settings());
    state = {};
    measure("waves run", run.terrain, [&] { run.tick(0.05); });
}

}  // namespace

void bench_erosion(double patch_pixels) {
    const std::unique_ptr<Simulation> cases[] = {hills(false, 1), hills(true, 1), hills(false, 0.1),
                                                 hills(true, 0.1)};
    std::vector<Contestant> contestants;
    std::vector<double> before;
    for (const auto& simulation : cases) {
        before.push_back(static_cast<double>(simulation->work("water").substeps));
        contestants.push_back({"", [s = simulation.get()] { s->apply(Ticks{1}); }});
    }
    constexpr int rounds = 9;
    const std::vector<double> seconds = interleave(contestants, rounds);
    std::vector<double> each;
    std::vector<double> substeps;
    for (std::size_t i = 0; i < seconds.size(); ++i) {
        substeps.push_back((static_cast<double>(cases[i]->work("water").substeps) - before[i]) /
                           (rounds + 1));
        each.push_back(seconds[i] / substeps[i]);
    }
    fmt::print("{}², a tick of half a second by sub-steps\n", tick_samples);
    fmt::print("{:<34} {:>8} {:>12} {:>10}\n", "", "ms/tick", "sub-steps", "ms/sub-step");
    const char* names[] = {"water alone", "water, sediment, slopes", "water alone, a tenth", "all, a tenth"};
    for (std::size_t i = 0; i < seconds.size(); ++i)
        fmt::print("{:<34} {:>8.1f} {:>12.1f} {:>10.2f}\n", names[i], 1e3 * seconds[i], substeps[i],
                   1e3 * each[i]);
    fmt::print("coupled costs {:.2f} times the water alone, a sub-step\n", each[1] / each[0]);
    fmt::print("a tenth active: {:.1f} times cheaper than all\n", each[1] / each[3]);
    schemes_of_slopes();
    error_against_time();
    large_field(patch_pixels);
}

}  // namespace talus::bench

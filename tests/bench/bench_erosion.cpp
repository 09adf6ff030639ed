// What erosion costs beside the water alone, and where little of the map is active.
#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "sim/simulation.h"
#include "sim/simulation_parameters.h"
#include "sim/terrain/generate.h"
#include "tests/bench/measure.h"

namespace talus::bench {

namespace {

constexpr int n = 1024;

// Hills under a running sheet of water, on all of the map or on a strip of that share.
std::unique_ptr<Simulation> hills(bool erodes, double share) {
    const Grid grid{n, n, 10, 10};
    TerrainState state = bedrock_terrain(grid, generate_heights(grid, {"hills", 3, 900}));
    state.water.assign(grid.count(), glm::vec4(0));
    for (std::size_t i = 0; i < grid.count(); ++i) {
        const bool inside = static_cast<double>(i % n) < share * n;
        // Beyond the strip a plateau stays dry.
        if (!inside) state.bedrock[i].x = 2000;
        if (inside) state.water[i].x = 0.5F;
    }
    Parameters all(simulation_parameters());
    for (const char* assignment :
         {"time.tick_s=0.5", "water.manning=0.04", "water.boundary.north=wall", "water.boundary.south=wall",
          "water.boundary.west=wall", "water.boundary.east=wall", "thermal.repose_deg=20",
          "thermal.bedrock_deg=89", "thermal.rate_m2_per_s=20", "erosion.erodibility=5",
          "erosion.bedrock_erodibility=1", "erosion.critical_shear=5", "erosion.porosity=0.3",
          "erosion.acceleration=10"})
        all.set_assignment(assignment);
    all.set("erosion.on", erodes);
    all.set("thermal.on", erodes);
    auto simulation = std::make_unique<Simulation>(state, all);
    simulation->apply(Ticks{4});
    return simulation;
}

}  // namespace

void bench_erosion() {
    const std::unique_ptr<Simulation> cases[] = {hills(false, 1), hills(true, 1), hills(false, 0.1),
                                                 hills(true, 0.1)};
    std::vector<Contestant> contestants;
    std::vector<double> before;
    for (const auto& simulation : cases) {
        before.push_back(static_cast<double>(simulation->water_work().substeps));
        contestants.push_back({"", [s = simulation.get()] { s->apply(Ticks{1}); }});
    }
    constexpr int rounds = 9;
    const std::vector<double> seconds = interleave(contestants, rounds);
    std::vector<double> each;
    std::vector<double> substeps;
    for (std::size_t i = 0; i < seconds.size(); ++i) {
        substeps.push_back((static_cast<double>(cases[i]->water_work().substeps) - before[i]) / (rounds + 1));
        each.push_back(seconds[i] / substeps[i]);
    }
    fmt::print("{}², a tick of half a second by sub-steps, CPU time of all threads\n", n);
    fmt::print("{:<34} {:>8} {:>12} {:>10}\n", "", "ms/tick", "sub-steps", "ms/sub-step");
    const char* names[] = {"water alone", "water, sediment, slopes", "water alone, a tenth", "all, a tenth"};
    for (std::size_t i = 0; i < seconds.size(); ++i)
        fmt::print("{:<34} {:>8.1f} {:>12.1f} {:>10.2f}\n", names[i], 1e3 * seconds[i], substeps[i],
                   1e3 * each[i]);
    fmt::print("coupled costs {:.2f} times the water alone, a sub-step\n", each[1] / each[0]);
    fmt::print("a tenth active: {:.1f} times cheaper than all\n", each[1] / each[3]);
}

}  // namespace talus::bench

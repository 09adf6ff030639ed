// The water under conditions that nobody asks for: never a number that is not finite, never a depth below 0,
// books that close, and energy that stays below its start plus what sources brought.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <random>

#include "sim/gpu/context.h"
#include "sim/passes/water_settings.h"
#include "sim/simulation.h"
#include "sim/simulation_parameters.h"
#include "sim/terrain/gauge.h"

namespace talus::water_stress_test {
namespace {

struct Stress {
    Grid grid;
    std::function<double(double, double)> bed;
    std::function<double(double, double)> depth;
    std::vector<std::string> settings;
    int ticks = 40;
    double drift = 1e-6;  // of all water that there ever was
    bool closed = true;   // walls, and nothing that brings water: energy only falls
};

Parameters parameters_of(const Stress& stress) {
    Parameters parameters(simulation_parameters());
    parameters.set("thermal.on", false);
    parameters.set("water.manning", 0.0);
    for (const char* edge : {"north", "south", "west", "east"})
        parameters.set(std::string("water.boundary.") + edge, std::string("wall"));
    for (const std::string& assignment : stress.settings) parameters.set_assignment(assignment);
    return parameters;
}

TerrainState state_of(const Stress& stress) {
    std::vector<float> beds;
    std::vector<glm::vec4> water;
    for (int row = 0; row < stress.grid.ny; ++row)
        for (int column = 0; column < stress.grid.nx; ++column) {
            const double x = column * stress.grid.dx;
            const double y = (stress.grid.ny - 1 - row) * stress.grid.dy;
            beds.push_back(static_cast<float>(stress.bed(x, y)));
            water.emplace_back(std::max(0.0, stress.depth(x, y)), 0, 0, 0);
        }
    TerrainState state = bedrock_terrain(stress.grid, beds);
    state.water = water;
    return state;
}

// Kinetic and potential energy over the density, m⁵/s².
double energy_of(const TerrainState& state) {
    const std::vector<float> ground = state.ground();
    const double datum = *std::min_element(ground.begin(), ground.end());
    double sum = 0;
    for (std::size_t i = 0; i < ground.size(); ++i) {
        const glm::vec4& w = state.water[i];
        const double h = w.x;
        const glm::dvec2 u = water_velocity(h, {w.z, w.w});
        sum += 0.5 * h * glm::dot(u, u) + 9.81 * h * (ground[i] - datum + h / 2);
    }
    return sum * state.grid.dx * state.grid.dy;
}

void check(const Stress& stress, const std::string& name) {
    SCOPED_TRACE(name);
    const TerrainState start = state_of(stress);
    Simulation simulation(start, parameters_of(stress));
    const double energy = energy_of(start);
    double most = 0;
    for (int tick = 0; tick < stress.ticks; ++tick) {
        simulation.apply(Ticks{1});
        if (tick % 8 != 0 && tick + 1 < stress.ticks) continue;
        const TerrainState now = simulation.read();
        float lowest = 0;
        bool finite = true;
        for (const glm::vec4& w : now.water) {
            finite = finite && std::isfinite(w.x) && std::isfinite(w.y) && std::isfinite(w.z) &&
                     std::isfinite(w.w);
            lowest = std::min(lowest, w.x);
        }
        ASSERT_TRUE(finite) << "at tick " << tick;
        ASSERT_GE(lowest, 0) << "at tick " << tick;
        most = std::max(most, energy_of(now));
    }
    const LedgerReading ledger = simulation.ledger();
    const PassWork work = simulation.work("water");
    fmt::print("{:<28} {:>6} sub-steps, drift {:+.1e}, energy at most {:.6f} of the start\n", name,
               work.substeps, ledger.water_drift_relative(), energy > 0 ? most / energy : 0);
    EXPECT_LE(std::abs(ledger.water_drift_relative()), stress.drift);
    if (stress.closed) {
        EXPECT_LE(most, energy * (1 + 1e-5) + 1e-9);
    }
}

double rough(double x, double y, double size) {
    return std::sin(x / size) * std::cos(y / (1.3 * size)) + 0.4 * std::sin((x + 2 * y) / (0.31 * size));
}

TEST(WaterStress, Extremes) {
    const gpu::Context context;
    const auto nothing = [](double, double) { return 0.0; };
    Stress cliff{{96, 64, 10, 10},
                 [](double x, double) { return x < 400 ? 10000.0 : 0.0; },
                 [](double x, double) { return x < 350 ? 5.0 : 0.0; },
                 {"time.tick_s=0.5"}};
    check(cliff, "cliff of 10 km");
    Stress film{{96, 64, 10, 10},
                [](double x, double y) { return 20 * rough(x, y, 90); },
                [](double, double) { return 1e-30; },
                {"time.tick_s=1"}};
    check(film, "film of 1e-30 m");
    Stress wave{{128, 64, 100, 100},
                [](double x, double y) { return 100 * rough(x, y, 900); },
                [](double x, double) { return x < 3000 ? 1000.0 : 1.0; },
                {"time.tick_s=2"}};
    check(wave, "wave of 1 km");
    Stress thin{{128, 2, 5, 5},
                [](double x, double) { return rough(x, 0, 40); },
                [](double x, double) { return x < 200 ? 6.0 : 0.0; },
                {"time.tick_s=0.5"}};
    check(thin, "128 x 2");
    Stress tall = thin;
    tall.grid = {2, 128, 5, 5};
    tall.depth = [](double, double y) { return y < 200 ? 6.0 : 0.0; };
    check(tall, "2 x 128");
    Stress tiny{
        {2, 2, 5, 5}, nothing, [](double x, double y) { return x + y > 6 ? 3.0 : 0.1; }, {"time.tick_s=0.5"}};
    check(tiny, "2 x 2");
    Stress stretched{{96, 96, 100, 1},
                     [](double x, double y) { return rough(x / 50, y / 5, 4); },
                     [](double x, double y) { return x < 3000 && y < 40 ? 8.0 : 0.5; },
                     {"time.tick_s=0.5"}};
    check(stretched, "dx / dy = 100");
    for (const double datum : {-10000.0, 10000.0}) {
        Stress deep{{96, 96, 10, 10},
                    [datum](double x, double y) { return datum + 5 * rough(x, y, 90); },
                    [](double x, double) { return x < 300 ? 12.0 : 2.0; },
                    {"time.tick_s=0.5"}};
        check(deep, fmt::format("bed at {:+.0f} m", datum));
    }
    Stress lightest{{96, 96, 10, 10},
                    [](double x, double y) { return 5 * rough(x, y, 90); },
                    [](double x, double) { return x < 300 ? 12.0 : 0.0; },
                    {"time.tick_s=1.666667"},
                    12};
    check(lightest, "tick x 100");
}

TEST(WaterStress, AnHourOfRain) {
    const gpu::Context context;
    for (const int order : {1, 2}) {
        Stress rain{{128, 96, 20, 20},
                    [](double x, double y) { return 200 * rough(x, y, 400); },
                    [](double, double) { return 0.0; },
                    {"time.tick_s=10", "water.rain_mm_per_h=50", "water.manning=0.03",
                     "water.infiltration_mm_per_h=5", fmt::format("water.order={}", order),
                     "water.boundary.east=open"},
                    360};
        rain.closed = false;
        check(rain, fmt::format("an hour of rain, order {}", order));
    }
}

// Scenes by seed; TALUS_STRESS_SCENES says how many (./dev soak runs more).
TEST(WaterStress, RandomScenes) {
    const gpu::Context context;
    const char* wanted = std::getenv("TALUS_STRESS_SCENES");
    const int count = wanted ? std::atoi(wanted) : 24;
    const std::vector<std::string>& kinds = edge_kinds();
    for (int seed = 1; seed <= count; ++seed) {
        std::mt19937 random(static_cast<unsigned>(seed));
        std::uniform_real_distribution<double> unit(0, 1);
        const auto between = [&](double low, double high) {
            return low * std::pow(high / low, unit(random));
        };
        Stress stress;
        stress.grid = {2 + static_cast<int>(random() % 140), 2 + static_cast<int>(random() % 140),
                       between(0.1, 100), between(0.1, 100)};
        const double height = between(0.01, 3000);
        const double size = between(2, 60);
        const double level = between(0.001, 300);
        const double share = unit(random);
        const Grid grid = stress.grid;
        stress.bed = [=](double x, double y) { return height * rough(x / grid.dx, y / grid.dy, size); };
        stress.depth = [=](double x, double y) {
            return x < share * grid.width_m() ? level - (seed % 2 == 0 ? stress.bed(x, y) : 0) : 0.0;
        };
        stress.ticks = 12;
        // About ten sub-steps a tick.
        const double fastest = std::sqrt(9.81 * (level + height));
        stress.settings = {
            fmt::format("time.tick_s={}", between(0.5, 20) * std::min(grid.dx, grid.dy) / fastest),
            fmt::format("water.order={}", 1 + seed % 2)};
        if (unit(random) < 0.5)
            stress.settings.push_back(fmt::format("water.manning={}", between(0.005, 0.2)));
        if (unit(random) < 0.5) {
            stress.closed = false;
            for (const char* edge : {"north", "south", "west", "east"})
                stress.settings.push_back(
                    fmt::format("water.boundary.{}={}", edge, kinds[random() % kinds.size()]));
            stress.settings.push_back(fmt::format("water.sea_level_m={}", level * unit(random)));
            stress.settings.push_back(fmt::format("water.inflow_m3_per_s={}", between(0.1, 1000) * grid.dx));
            stress.settings.push_back(fmt::format("water.wave_height_m={}", level * 0.2 * unit(random)));
            stress.settings.push_back(fmt::format("water.rain_mm_per_h={}", between(1, 10000)));
            stress.settings.push_back(fmt::format("water.evaporation_mm_per_h={}", between(1, 10000)));
        }
        check(stress, fmt::format("seed {}", seed));
        if (HasFatalFailure()) return;
    }
}

}  // namespace
}  // namespace talus::water_stress_test

// Erosion under conditions that nobody asks for: all stays finite, nothing falls below 0, no spike grows,
// books close.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <random>

#include "sim/gpu/context.h"
#include "sim/simulation.h"
#include "sim/simulation_parameters.h"
#include "sim/terrain/generate.h"

namespace talus::erosion_stress_test {
namespace {

struct Stress {
    TerrainState state;
    std::vector<std::string> settings;
    int ticks = 40;
};

// How far the highest sample stands above all of its neighbours, m.
double tallest_spike(const TerrainState& state) {
    const Grid& grid = state.grid;
    const std::vector<float> ground = state.ground();
    const auto at = [&](int x, int y) { return ground[static_cast<std::size_t>(y) * grid.nx + x]; };
    double tallest = 0;
    for (int y = 1; y < grid.ny - 1; ++y)
        for (int x = 1; x < grid.nx - 1; ++x) {
            float highest = -1e30F;
            for (int j = -1; j <= 1; ++j)
                for (int i = -1; i <= 1; ++i)
                    if (i != 0 || j != 0) highest = std::max(highest, at(x + i, y + j));
            tallest = std::max(tallest, static_cast<double>(at(x, y)) - highest);
        }
    return tallest;
}

// Sum of all rises from sample to sample, m.
double variation_of(const TerrainState& state) {
    const Grid& grid = state.grid;
    const std::vector<float> ground = state.ground();
    double sum = 0;
    for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x) {
            const std::size_t at = static_cast<std::size_t>(y) * grid.nx + x;
            if (x > 0) sum += std::abs(static_cast<double>(ground[at]) - ground[at - 1]);
            if (y > 0) sum += std::abs(static_cast<double>(ground[at]) - ground[at - grid.nx]);
        }
    return sum;
}

void expect_sound(const TerrainState& now) {
    for (std::size_t i = 0; i < now.bedrock.size(); ++i) {
        ASSERT_TRUE(
            std::isfinite(now.bedrock[i].x + now.bedrock[i].y + now.regolith[i].x + now.regolith[i].y));
        ASSERT_GE(now.regolith[i].x, 0);
        if (!now.suspended.empty()) {
            ASSERT_TRUE(std::isfinite(now.suspended[i].x + now.suspended[i].y));
            ASSERT_GE(now.suspended[i].x, 0);
        }
        if (now.water.empty()) continue;
        const glm::vec4& w = now.water[i];
        ASSERT_TRUE(std::isfinite(w.x + w.y + w.z + w.w));
        ASSERT_GE(w.x, 0);
    }
}

Simulation simulation_of(const Stress& stress) {
    Parameters all(simulation_parameters());
    for (const char* assignment :
         {"erosion.on=true", "erosion.erodibility=5", "erosion.bedrock_erodibility=1", "erosion.porosity=0.3",
          "erosion.acceleration=20", "water.manning=0.04", "water.rain_mm_per_h=300", "time.tick_s=1",
          "thermal.on=false"})
        all.set_assignment(assignment);
    for (const std::string& assignment : stress.settings) all.set_assignment(assignment);
    return {stress.state, all};
}

void check(const Stress& stress, const std::string& name) {
    SCOPED_TRACE(name);
    Simulation simulation = simulation_of(stress);
    for (int tick = 0; tick < stress.ticks; ++tick) {
        simulation.apply(Ticks{1});
        if (tick % 10 != 0 && tick + 1 < stress.ticks) continue;
        expect_sound(simulation.read());
        if (testing::Test::HasFatalFailure()) return;
    }
    const TerrainState end = simulation.read();
    const LedgerReading ledger = simulation.ledger();
    fmt::print(
        "{:<44} {:>6} sub-steps, eroded {:.2e} m3, closing error {:.1e} of it, tallest spike {:.1f} m of "
        "{:.1f}, "
        "variation {:.4f} of the start\n",
        name, simulation.work("water").substeps, ledger.eroded_m3, ledger.closing_error_of_eroded(),
        tallest_spike(end), tallest_spike(stress.state), variation_of(end) / variation_of(stress.state));
    EXPECT_LE(ledger.closing_error_of_eroded(), 1e-5);
    EXPECT_LE(std::abs(ledger.water_drift_relative()), 1e-6);
    // Grains of a deposit and the steps of a channel are no spikes.
    EXPECT_LE(tallest_spike(end), 1.02 * tallest_spike(stress.state) + 2.0);
}

TerrainState under_water(const Grid& grid, const std::function<double(int, int)>& height, float depth) {
    std::vector<float> heights;
    for (int row = 0; row < grid.ny; ++row)
        for (int column = 0; column < grid.nx; ++column)
            heights.push_back(static_cast<float>(height(column, row)));
    TerrainState state = bedrock_terrain(grid, heights);
    state.water.assign(grid.count(), glm::vec4(depth, 0, 0, 0));
    return state;
}

TEST(ErosionStress, Extremes) {
    const gpu::Context context;
    const Grid grid{96, 80, 15, 15};
    const std::vector<float> heights = generate_heights(grid, {"mountains", 5, 500});
    const auto mountains = [&](int x, int y) { return heights[static_cast<std::size_t>(y) * 96 + x]; };
    const TerrainState rocks = under_water(grid, mountains, 0.3F);
    check({rocks, {}}, "mountains");
    check({rocks, {"water.order=1"}}, "mountains, order 1");
    check({rocks, {"erosion.erodibility=5000", "erosion.bedrock_erodibility=1000"}}, "erodibility x 1000");
    check({rocks, {"erosion.acceleration=1000"}}, "acceleration 1000");
    check({rocks,
           {"erosion.acceleration=1000", "erosion.erodibility=5000", "erosion.bedrock_erodibility=1000",
            "time.tick_s=100"},
           3},
          "both, at a tick of 100 s");
    TerrainState checkered = rocks;
    checkered.painted.assign(grid.count(), glm::vec4(0));
    for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x)
            checkered.painted[static_cast<std::size_t>(y) * 96 + x].x = static_cast<float>((x + y) % 2);
    check({checkered, {"erosion.bedrock_erodibility=100"}}, "hardness 0 and 1 in a checkerboard");
    TerrainState dusty = rocks;
    for (std::size_t i = 0; i < grid.count(); ++i) dusty.regolith[i].x = i % 3 == 0 ? 1e-7F : 3.0F;
    check({dusty, {"thermal.on=true", "thermal.bedrock_deg=60"}}, "regolith of 3 m and of 1e-7 m");
    const auto spiky = [&](int x, int y) {
        return mountains(x, y) + ((x * 31 + y * 17) % 97 == 0 ? 5000 : 0);
    };
    check({under_water(grid, spiky, 0.3F), {}, 6}, "spikes of 5 km");
    check({under_water(grid, spiky, 0.3F),
           {"thermal.on=true", "thermal.bedrock_deg=70", "erosion.acceleration=1000"},
           6},
          "spikes of 5 km, sliding, acceleration 1000");
    check({under_water(
               {96, 2, 15, 15}, [](int x, int) { return 2.0 * x; }, 0.5F),
           {}},
          "96 x 2");
    check({under_water(
               {60, 60, 100, 1}, [](int x, int y) { return 20 * std::sin(0.2 * x) + 0.2 * y; }, 0.5F),
           {}},
          "dx / dy = 100");
    for (const double datum : {-10000.0, 10000.0})
        check({under_water(
                   grid, [&](int x, int y) { return mountains(x, y) + datum; }, 0.3F),
               {}},
              fmt::format("bed at {:+.0f} m", datum));
}

// Without a source nothing makes the ground rougher: sliding alone, and a cloudy lake that settles.
TEST(ErosionStress, VariationFallsWithoutASource) {
    const gpu::Context context;
    const Grid grid{90, 90, 10, 10};
    const auto spiky = [](int x, int y) {
        return 3.0 * std::sin(0.2 * x + 0.1 * y) + ((x * 31 + y * 17) % 97 == 0 ? 5000 : 0);
    };
    Stress slides{under_water(grid, spiky, 0.0F),
                  {"thermal.on=true", "thermal.weathering_mm_per_h=0", "water.rain_mm_per_h=0"},
                  0};
    slides.state.water.clear();
    Simulation simulation = simulation_of(slides);
    double before = variation_of(slides.state);
    for (int i = 0; i < 20; ++i) {
        simulation.apply(Ticks{25});
        const double now = variation_of(simulation.read());
        EXPECT_LE(now, before * (1 + 1e-9));
        before = now;
    }
    fmt::print("spikes of 5 km slide: variation at {:.4f} of the start\n",
               before / variation_of(slides.state));
    EXPECT_LE(simulation.ledger().closing_error_of_eroded(), 1e-6);

    Stress lake{under_water(
                    grid, [](int, int) { return 5.0; }, 3.0F),
                {"water.rain_mm_per_h=0", "erosion.settling_mm_per_s=100", "water.boundary.north=wall",
                 "water.boundary.south=wall", "water.boundary.west=wall", "water.boundary.east=wall"},
                0};
    lake.state.suspended.assign(grid.count(), glm::vec2(0.01F, 0));
    Simulation settling = simulation_of(lake);
    settling.apply(Ticks{2000});
    EXPECT_EQ(settling.ledger().suspended, 0);
    EXPECT_EQ(variation_of(settling.read()), 0);
    EXPECT_NEAR(settling.read().regolith[100].x, 0.01 * 20 / 0.7, 1e-5);
}

// A small map in the rain for very many ticks; TALUS_SOAK_TICKS says how many (./dev soak: a million).
TEST(ErosionStress, ManyTicks) {
    const gpu::Context context;
    const char* wanted = std::getenv("TALUS_SOAK_TICKS");
    const int ticks = wanted ? std::atoi(wanted) : 3000;
    const Grid grid{64, 64, 20, 20};
    const Stress stress{
        bedrock_terrain(grid, generate_heights(grid, {"hills", 8, 150})),
        {"time.tick_s=0.5", "water.rain_mm_per_h=60", "thermal.on=true", "thermal.bedrock_deg=60",
         "thermal.weathering_mm_per_h=1", "thermal.wet_deg=25", "erosion.acceleration=10"},
        0};
    Simulation simulation = simulation_of(stress);
    for (int part = 1; part <= 10; ++part) {
        simulation.apply(Ticks{ticks / 10});
        expect_sound(simulation.read());
        if (HasFatalFailure()) return;
        const LedgerReading ledger = simulation.ledger();
        fmt::print(
            "after {} ticks: eroded {:.3e} m3, out {:.3e} m3, closing error {:.1e} of eroded, water drift "
            "{:+.1e}\n",
            part * (ticks / 10), ledger.eroded_m3, ledger.solid_edges_out, ledger.closing_error_of_eroded(),
            ledger.water_drift_relative());
        EXPECT_LE(ledger.closing_error_of_eroded(), 1e-5);
        EXPECT_LE(std::abs(ledger.water_drift_relative()), 1e-6);
    }
}

// Scenes by seed; TALUS_STRESS_SCENES says how many (./dev soak runs more).
TEST(ErosionStress, RandomScenes) {
    const gpu::Context context;
    const char* wanted = std::getenv("TALUS_STRESS_SCENES");
    const int count = wanted ? std::atoi(wanted) : 12;
    for (int seed = 1; seed <= count; ++seed) {
        std::mt19937 random(static_cast<unsigned>(seed));
        std::uniform_real_distribution<double> unit(0, 1);
        const auto between = [&](double low, double high) {
            return low * std::pow(high / low, unit(random));
        };
        const double spacing = between(0.5, 100);
        const Grid grid{2 + static_cast<int>(random() % 110), 2 + static_cast<int>(random() % 110), spacing,
                        spacing * between(0.5, 2)};
        const char* kinds[] = {"mountains", "hills", "coast", "valley"};
        const double relief = spacing * between(1, 60);
        const std::vector<float> heights =
            generate_heights(grid, {kinds[seed % 4], static_cast<unsigned>(seed), relief});
        Stress stress{
            under_water(
                grid, [&](int x, int y) { return heights[static_cast<std::size_t>(y) * grid.nx + x]; },
                static_cast<float>(between(0.01, 2))),
            {fmt::format("time.tick_s={}", spacing * between(0.02, 1)),
             fmt::format("water.order={}", 1 + seed % 2),
             fmt::format("water.rain_mm_per_h={}", between(1, 3000)),
             fmt::format("erosion.erodibility={}", between(0.1, 1000)),
             fmt::format("erosion.bedrock_erodibility={}", between(0.1, 300)),
             fmt::format("erosion.critical_shear_pa={}", between(0.01, 100)),
             fmt::format("erosion.settling_mm_per_s={}", between(0.1, 500)),
             fmt::format("erosion.porosity={}", 0.6 * unit(random)),
             fmt::format("erosion.acceleration={}", between(1, 1000)),
             fmt::format("thermal.on={}", seed % 3 == 0 ? "true" : "false"), "thermal.bedrock_deg=60"},
            20};
        check(stress, fmt::format("seed {}", seed));
        if (HasFatalFailure()) return;
    }
}

}  // namespace
}  // namespace talus::erosion_stress_test

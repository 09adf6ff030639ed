// Erosion in a session: undo, replay, saving midway and the frame rate change no bit, and its books close.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <random>

#include "sim/gpu/context.h"
#include "sim/io/document.h"
#include "sim/passes/thermal_twin.h"
#include "sim/preset.h"
#include "sim/simulation.h"
#include "sim/simulation_parameters.h"
#include "sim/terrain/generate.h"
#include "sim/terrain/state_hash.h"
#include "tests/scenes/undo_trail.h"
#include "tests/scenes/wait_until.h"

namespace talus::erosion_simulation_test {
namespace {

constexpr std::size_t undo_bytes = 256U << 20U;
const Grid grid{150, 97, 20, 25};

TerrainState coast() {
    return bedrock_terrain(grid, generate_heights(grid, {"coast", 5, 160}));
}

// Rain and a silty river over a coast whose slopes slide, lower when they are wet.
Parameters parameters(int order) {
    Parameters all(simulation_parameters());
    for (const char* assignment :
         {"time.tick_s=2", "water.sea_level=45", "water.boundary.west=level", "water.boundary.east=inflow",
          "water.inflow=500", "water.rain=300", "erosion.on=true", "erosion.erodibility=20",
          "erosion.bedrock_erodibility=5", "erosion.critical_shear=2", "erosion.porosity=0.3",
          "erosion.acceleration=30", "erosion.inflow_concentration=0.004", "erosion.strata_m=12",
          "thermal.repose_deg=24", "thermal.wet_deg=12", "thermal.bedrock_deg=50", "thermal.weathering=500",
          "thermal.rate_m2_per_s=20"})
        all.set_assignment(assignment);
    all.set("water.order", order);
    return all;
}

std::uint64_t hash_of(const Simulation& simulation) {
    return state_hash(simulation.read());
}

Dab random_dab(std::mt19937& random) {
    std::uniform_real_distribution<double> unit(0, 1);
    const Material materials[] = {Material::bedrock, Material::regolith, Material::water, Material::hardness};
    Dab dab;
    dab.effect = effect_of(random() % 3 == 0 ? BrushMode::lower : BrushMode::raise);
    dab.x_m = grid.width_m() * unit(random);
    dab.y_m = grid.height_m() * unit(random);
    dab.radius_m = 30 + 300 * unit(random);
    dab.amount_m = 10 * unit(random);
    dab.blend = 0.6;
    dab.material = materials[random() % 4];
    dab.target_m = dab.is_paint() && dab.mode() == BrushMode::raise ? 1 : 0;
    return dab;
}

void play(Simulation& simulation, int first, int last, int substeps) {
    std::mt19937 random(static_cast<unsigned>(first));
    for (int tick = first; tick < last; ++tick) {
        if (tick % 3 == 0) simulation.apply(random_dab(random));
        if (tick == 14) simulation.apply(SetParameter{"erosion.acceleration", 45.0});
        while (!simulation.advance(substeps)) {
        }
    }
}

class ErosionOfEitherOrder : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(ErosionSimulation, ErosionOfEitherOrder, testing::Values(1, 2));

TEST_P(ErosionOfEitherOrder, FrameRateReplayAndSavingMidwayChangeNoBit) {
    const gpu::Context context;
    Simulation whole(coast(), parameters(GetParam()));
    play(whole, 0, 10, 1 << 20);
    play(whole, 10, 25, 1 << 20);
    Simulation in_parts(coast(), parameters(GetParam()), undo_bytes);
    play(in_parts, 0, 10, 1);
    play(in_parts, 10, 25, 3);
    EXPECT_EQ(hash_of(whole), hash_of(in_parts));
    EXPECT_FALSE(whole.read().suspended.empty());

    Simulation first(coast(), parameters(GetParam()));
    play(first, 0, 10, 2);
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / ("talus_erosion_" + std::to_string(::getpid()) + ".exr");
    io::Document document;
    document.state = first.read();
    document.parameters = to_toml(first.parameters());
    io::save_document(file, document);
    const io::Document loaded = io::open_document(file, {});
    std::filesystem::remove(file);
    Parameters again(simulation_parameters());
    from_toml(loaded.parameters, "document", again);
    EXPECT_EQ(state_hash(loaded.state), hash_of(first));
    Simulation second(loaded.state, again);
    play(second, 10, 25, 2);
    EXPECT_EQ(hash_of(whole), hash_of(second));

    const std::string text = write_journal({"", "", "{}", 0}, whole.journal());
    Simulation replayed(coast(), parameters(GetParam()));
    for (const Operation& operation : read_journal(text, "journal").operations) replayed.apply(operation);
    EXPECT_EQ(hash_of(whole), hash_of(replayed));
}

TEST_P(ErosionOfEitherOrder, UndoesAndRedoesToTheBit) {
    const gpu::Context context;
    // It begins dry, without erosion: the first entries are made where there is no such layer.
    Parameters dry = parameters(GetParam());
    dry.set("erosion.on", false);
    dry.set("water.rain", 0.0);
    dry.set("water.inflow", 0.0);
    Simulation simulation(coast(), dry, undo_bytes);
    std::mt19937 random(7);
    const auto act = [&](int entry) {
        if (entry == 1) {
            simulation.apply(SetParameter{"water.rain", 300.0});
        } else if (entry == 3) {
            simulation.apply(SetParameter{"erosion.on", true});
        } else if (entry == 7) {
            simulation.apply(SetParameter{"erosion.porosity", 0.4});
        } else if (entry == 9) {
            simulation.apply(SetParameter{"erosion.acceleration", 100.0});
        } else if (entry % 2 == 0) {
            simulation.apply(Ticks{3});
            simulation.end_entry();
        } else {
            simulation.begin_stroke("raise");
            for (int i = 0; i < 3; ++i) {
                simulation.apply(random_dab(random));
                simulation.apply(Ticks{1});
            }
            simulation.end_entry();
        }
    };
    const auto expect_same = [](const LedgerReading& a, const LedgerReading& b) {
        EXPECT_EQ(a.solid_final, b.solid_final);
        EXPECT_EQ(a.solid_in, b.solid_in);
        EXPECT_EQ(a.solid_out, b.solid_out);
        EXPECT_EQ(a.suspended, b.suspended);
        EXPECT_EQ(a.eroded_m3, b.eroded_m3);
    };
    expect_undo_leads_back_and_forth(simulation, 12, act, expect_same);
}

// Everything at once: brushes, rain, a silty river, open edges, sliding, weathering; and weights that change
// midway.
TEST_P(ErosionOfEitherOrder, TheBooksClose) {
    const gpu::Context context;
    Simulation simulation(coast(), parameters(GetParam()));
    std::mt19937 random(3);
    for (int i = 0; i < 30; ++i) {
        simulation.apply(random_dab(random));
        if (i == 12) simulation.apply(SetParameter{"erosion.porosity", 0.45});
        if (i == 20) simulation.apply(SetParameter{"erosion.acceleration", 80.0});
        simulation.apply(Ticks{3});
    }
    const LedgerReading ledger = simulation.ledger();
    EXPECT_GT(ledger.eroded_m3, 1e5);
    EXPECT_GT(ledger.deposited_m3, 1e5);
    EXPECT_GT(ledger.suspended, 1e3);
    EXPECT_GT(ledger.solid_in, 1e5);
    EXPECT_GT(ledger.regolith, 1e5);
    EXPECT_LE(ledger.closing_error_of_eroded(), 1e-6);
    std::vector<float> depths;
    for (const glm::vec2& regolith : simulation.read().regolith) EXPECT_GE(regolith.x, 0);
}

// Asked for without waiting, the ledger reads as when one waits, of the moment at which it was asked.
TEST(ErosionSimulation, TheLedgerIsFollowedWithoutWaiting) {
    const gpu::Context context;
    Simulation simulation(coast(), parameters(2));
    for (int i = 0; i < 5; ++i) {
        simulation.apply(Ticks{2});
        const LedgerReading waited = simulation.ledger();
        simulation.ask_ledger();
        simulation.apply(Ticks{1});
        std::optional<LedgerReading> followed;
        ASSERT_TRUE(wait_until([&] { return (followed = simulation.poll_ledger()).has_value(); }));
        EXPECT_EQ(followed->solid_final, waited.solid_final);
        EXPECT_EQ(followed->solid_in, waited.solid_in);
        EXPECT_EQ(followed->eroded_m3, waited.eroded_m3);
        EXPECT_EQ(followed->water_in, waited.water_in);
        EXPECT_EQ(followed->water_out, waited.water_out);
        EXPECT_FALSE(simulation.poll_ledger());
    }
}

// By the mask, water takes and slopes slide where a brush painted and nowhere else.
TEST(ErosionSimulation, ErodesWhereItWasPainted) {
    const gpu::Context context;
    Parameters all = parameters(2);
    all.set("erosion.over", std::string("mask"));
    all.set("erosion.inflow_concentration", 0.0);
    const TerrainState start = coast();
    Simulation simulation(start, all);
    simulation.apply(Ticks{5});
    EXPECT_EQ(simulation.read().bedrock, start.bedrock) << "nothing was painted yet";
    Dab dab;
    dab.x_m = 2000;
    dab.y_m = 1200;
    dab.radius_m = 400;
    dab.falloff = 0;
    dab.blend = 1;
    dab.target_m = 1;
    dab.material = Material::mask;
    simulation.apply(dab);
    simulation.apply(Ticks{20});
    const TerrainState end = simulation.read();
    std::size_t inside = 0;
    for (std::size_t i = 0; i < grid.count(); ++i) {
        if (end.bedrock[i] == start.bedrock[i]) continue;
        ++inside;
        EXPECT_EQ(end.painted[i].y, 1);
    }
    EXPECT_GT(inside, 200U);
    EXPECT_LE(simulation.ledger().closing_error_of_moved(), 1e-6);
}

// Slopes that rest because the mask is 0 wake when it is painted: as in a run that goes on from a file.
TEST(ErosionSimulation, PaintingTheMaskWakesSlopes) {
    const gpu::Context context;
    Parameters all(simulation_parameters());
    for (const char* assignment : {"time.tick_s=1", "thermal.repose_deg=5", "erosion.over=mask"})
        all.set_assignment(assignment);
    const TerrainState start = coast();
    Simulation simulation(start, all);
    Dab dab;
    dab.x_m = 300;
    dab.y_m = 300;
    dab.radius_m = 200;
    dab.blend = 1;
    dab.target_m = 1;
    dab.material = Material::hardness;
    simulation.apply(dab);
    simulation.apply(Ticks{3});
    EXPECT_EQ(simulation.read().bedrock, start.bedrock);
    dab.x_m = 2000;
    dab.y_m = 1200;
    dab.material = Material::mask;
    simulation.apply(dab);
    Simulation reloaded(simulation.read(), simulation.parameters());
    simulation.apply(Ticks{5});
    reloaded.apply(Ticks{5});
    EXPECT_NE(simulation.read().bedrock, start.bedrock);
    EXPECT_EQ(hash_of(simulation), hash_of(reloaded));
}

// Off, nothing new is taken and what is on its way settles.
TEST(ErosionSimulation, OffItLetsEverythingSettle) {
    const gpu::Context context;
    Simulation simulation(coast(), parameters(2));
    simulation.apply(Ticks{20});
    EXPECT_GT(simulation.ledger().suspended, 0);
    for (const char* name : {"water.rain", "water.inflow"}) simulation.apply(SetParameter{name, 0.0});
    simulation.apply(SetParameter{"erosion.on", false});
    simulation.apply(SetParameter{"erosion.settling", 1000.0});
    const std::vector<glm::vec2> bedrock = simulation.read().bedrock;
    simulation.apply(SetParameter{"thermal.on", false});
    // A silty river comes clear then.
    simulation.apply(SetParameter{"water.inflow", 500.0});
    const double brought = simulation.ledger().solid_in;
    simulation.apply(Ticks{20});
    EXPECT_EQ(simulation.ledger().solid_in, brought);
    simulation.apply(SetParameter{"water.inflow", 0.0});
    simulation.apply(Ticks{200});
    EXPECT_EQ(simulation.ledger().suspended, 0);
    EXPECT_EQ(simulation.read().bedrock, bedrock);
    EXPECT_LE(simulation.ledger().closing_error_of_eroded(), 1e-6);
}

// 1e-7 m a tick for 1e5 ticks at 4,000 m, a two-thousandth of the height's last digit each. By the twin,
// whose bits are the device's.
TEST(ErosionSimulation, GrainsBelowTheLastDigitAddUp) {
    const Grid small{2, 2, 10, 10};
    ThermalSettings settings;
    settings.weathering_m_per_s = 1e-7;
    settings.porosity = 0.2;
    maths::ThermalTwin<float> twin(small, thermal_step(small, settings, 1, 1));
    twin.samples.assign(4, glm::vec4(4000, 0, 0, 0));
    for (int tick = 0; tick < 100000; ++tick) twin.step();
    const glm::dvec4 end(twin.samples[0]);
    // dR/dt = bulking w / (1 + R / 0.5), so R + R² = bulking w t.
    const double regolith = end.z + end.w;
    EXPECT_NEAR((regolith + regolith * regolith) / (1.25 * 1e-7 * 1e5), 1, 1e-3);
    EXPECT_NEAR((4000 - (end.x + end.y)) * 1.25 / regolith, 1, 1e-5);
}

// Regolith lies at its own angle on bedrock that stands steeper, and lower under water.
TEST(ErosionSimulation, RegolithRestsAtItsOwnAngle) {
    const gpu::Context context;
    const Grid plane{90, 70, 5, 5};
    const auto steepest_after = [&](double bedrock_slope, double depth_m, double water_m) {
        TerrainState state = bedrock_terrain(plane, std::vector<float>(plane.count(), 0.0F));
        state.water.assign(plane.count(), glm::vec4(0));
        for (std::size_t i = 0; i < plane.count(); ++i) {
            const double x = static_cast<double>(i % 90) * 5;
            state.bedrock[i].x =
                static_cast<float>(std::max(0.0, bedrock_slope * (200 - std::abs(x - 225)) - 40));
            if (std::abs(x - 225) < 30) state.regolith[i].x = static_cast<float>(depth_m);
            state.water[i].x = static_cast<float>(water_m);
        }
        Parameters all(simulation_parameters());
        for (const char* assignment : {"time.tick_s=1", "thermal.repose_deg=33", "thermal.wet_deg=18",
                                       "thermal.bedrock_deg=60", "water.on=false"})
            all.set_assignment(assignment);
        Simulation simulation(state, all);
        simulation.apply(Ticks{4000});
        const TerrainState end = simulation.read();
        const std::vector<float> ground = end.ground();
        double steepest = 0;
        for (std::size_t i = 0; i + 1 < plane.count(); ++i)
            if (i % 90 < 89 && end.regolith[i].x > 0.5F && end.regolith[i + 1].x > 0.5F)
                steepest = std::max(steepest, std::abs(static_cast<double>(ground[i + 1]) - ground[i]) / 5);
        // The bedrock, at less than its angle, stands as it stood.
        EXPECT_EQ(end.bedrock, state.bedrock);
        return std::atan(steepest) * 180 / std::acos(-1.0);
    };
    EXPECT_NEAR(steepest_after(1.2, 15, 0), 33, 0.5);
    EXPECT_NEAR(steepest_after(0.4, 15, 500), 18, 0.5);
}

}  // namespace
}  // namespace talus::erosion_simulation_test

// Water in a session: undo, replay, saving midway and the frame rate change no bit, and its books close.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include "app/core/gauges.h"
#include "app/core/scene.h"
#include "app/core/wave_note.h"
#include "render/overview.h"
#include "render/renderer.h"
#include "sim/error.h"
#include "sim/gpu/context.h"
#include "sim/io/document.h"
#include "sim/passes/water_settings.h"
#include "sim/preset.h"
#include "sim/simulation.h"
#include "sim/simulation_parameters.h"
#include "sim/terrain/bed_beyond.h"
#include "sim/terrain/gauge.h"
#include "sim/terrain/generate.h"
#include "sim/terrain/sea.h"
#include "sim/terrain/state_hash.h"
#include "tests/scenes/undo_trail.h"
#include "tests/scenes/wait_until.h"

namespace talus::water_simulation_test {
namespace {

constexpr std::size_t undo_bytes = 256U << 20U;
const Grid grid{150, 97, 20, 25};

// A part of a larger coast: the ground beyond its edges is known in stretches.
TerrainState coast() {
    TerrainState state = bedrock_terrain(grid, generate_heights(grid, {"coast", 5, 120}));
    state.bed_beyond = bed_beyond_of(grid, [ground = state.ground()](glm::ivec2 at) {
        const glm::ivec2 inside = glm::clamp(at, glm::ivec2(0), glm::ivec2(grid.nx, grid.ny) - 1);
        if ((at.x + at.y) / 20 % 2 == 0) return glsl::unknown_bed;
        return ground[static_cast<std::size_t>(inside.y) * grid.nx + inside.x] +
               0.37F * static_cast<float>((at.x + at.y) % 7) - 1;
    });
    return state;
}

// Rain, a river, waves and a sea over a coast that slides.
Parameters parameters() {
    Parameters all(simulation_parameters());
    for (const char* assignment :
         {"time.tick_s=0.7", "water.sea_level=45", "water.boundary.west=wave", "water.boundary.east=inflow",
          "water.boundary.south=level", "water.inflow=300", "water.inflow_rise=10", "water.rain=200",
          "water.evaporation=30", "water.wave_height=0.5", "water.wave_period=9"})
        all.set_assignment(assignment);
    return all;
}

std::uint64_t hash_of(const Simulation& simulation) {
    return state_hash(simulation.read());
}

Dab water_dab(std::mt19937& random) {
    std::uniform_real_distribution<double> unit(0, 1);
    Dab dab;
    dab.effect = effect_of(random() % 3 == 0 ? BrushMode::lower : BrushMode::raise);
    dab.x_m = grid.width_m() * unit(random);
    dab.y_m = grid.height_m() * unit(random);
    dab.radius_m = 30 + 300 * unit(random);
    dab.amount_m = 20 * unit(random);
    dab.material = random() % 3 == 0 ? Material::bedrock : Material::water;
    return dab;
}

Dab paint_dab(std::mt19937& random) {
    Dab dab = water_dab(random);
    dab.material = random() % 2 == 0 ? Material::rain : Material::mask;
    dab.blend = 0.7;
    dab.target_m = dab.mode() == BrushMode::lower ? 0 : dab.material == Material::rain ? 400 : 1;
    return dab;
}

void expect_same(const LedgerReading& a, const LedgerReading& b) {
    EXPECT_EQ(a.water_final, b.water_final);
    EXPECT_EQ(a.water_in, b.water_in);
    EXPECT_EQ(a.water_out, b.water_out);
    EXPECT_EQ(a.solid_in, b.solid_in);
}

class EitherOrder : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(WaterSimulation, EitherOrder, testing::Values(1, 2));

TEST_P(EitherOrder, UndoesAndRedoesToTheBit) {
    const gpu::Context context;
    // It begins dry: the first entries are made where no water is.
    Parameters dry(simulation_parameters());
    dry.set("water.order", GetParam());
    dry.set("time.tick_s", 0.7);
    Simulation simulation(coast(), dry, undo_bytes);
    std::mt19937 random(7);
    const auto act = [&](int entry) {
        if (entry == 0) {
            Dab dab = water_dab(random);
            dab.material = Material::bedrock;
            simulation.apply(dab);
        } else if (entry == 2) {
            simulation.apply(SetParameter{"water.sea_level", 40.0});
        } else if (entry == 3) {
            simulation.apply(SetParameter{"water.rain", 300.0});
        } else if (entry == 4) {
            simulation.apply(PlaceSpring{1500, 1200, 20});
        } else if (entry % 2 == 0) {
            simulation.apply(Ticks{3});
            simulation.end_entry();
        } else {
            simulation.begin_stroke("raise");
            for (int i = 0; i < 3; ++i) {
                simulation.apply(water_dab(random));
                simulation.apply(paint_dab(random));
                simulation.apply(Ticks{1});
            }
            simulation.end_entry();
        }
    };
    expect_undo_leads_back_and_forth(simulation, 12, act, expect_same);
}

// A trickle that stays below the threshold of rest, and a puddle that dries up in one tick.
TEST(WaterSimulation, UndoesWhatTooLittleToFlowBroughtAndTook) {
    const gpu::Context context;
    Parameters quiet(simulation_parameters());
    quiet.set("time.tick_s", 1.0);
    Simulation simulation(coast(), quiet, undo_bytes);
    simulation.apply(PlaceSpring{1500, 1200, 1e-6});
    const std::uint64_t before = hash_of(simulation);
    simulation.apply(Ticks{5});
    simulation.end_entry();
    EXPECT_NE(hash_of(simulation), before);
    simulation.undo();
    EXPECT_EQ(hash_of(simulation), before);

    TerrainState puddle = bedrock_terrain(grid, std::vector<float>(grid.count(), 10.0F));
    puddle.water.assign(grid.count(), glm::vec4(0));
    for (std::size_t i = 0; i < grid.count(); ++i) puddle.water[i].x = 0.05F;
    Parameters hot(simulation_parameters());
    hot.set("time.tick_s", 3600.0);
    hot.set("water.evaporation", 1000.0);
    Simulation dries(puddle, hot, undo_bytes);
    const std::uint64_t wet = hash_of(dries);
    dries.apply(Ticks{1});
    dries.end_entry();
    EXPECT_TRUE(dries.read().water.empty());
    dries.undo();
    EXPECT_EQ(hash_of(dries), wet);
}

TEST(WaterSimulation, ASeaLevelThatIsDraggedIsOneAct) {
    const gpu::Context context;
    Simulation simulation(coast(), Parameters(simulation_parameters()), undo_bytes);
    const std::uint64_t dry = hash_of(simulation);
    for (const double level : {20.0, 60.0, 45.0}) simulation.apply(SetParameter{"water.sea_level", level});
    Simulation straight(coast(), Parameters(simulation_parameters()));
    straight.apply(SetParameter{"water.sea_level", 45.0});
    EXPECT_EQ(hash_of(simulation), hash_of(straight));
    EXPECT_EQ(simulation.ledger().water_in, straight.ledger().water_in);
    simulation.undo();
    EXPECT_EQ(hash_of(simulation), dry);
    EXPECT_FALSE(simulation.can_undo());
}

// A right click on the sea's level takes back the sea that was just set, and the next level fills anew.
TEST(WaterSimulation, AnUnsetSeaGoes) {
    const gpu::Context context;
    Simulation simulation(coast(), Parameters(simulation_parameters()), undo_bytes);
    const std::uint64_t dry = hash_of(simulation);
    simulation.apply(SetParameter{"water.sea_level", 60.0});
    EXPECT_NE(hash_of(simulation), dry);
    simulation.apply(SetParameter{"water.sea_level", std::nullopt});
    EXPECT_EQ(hash_of(simulation), dry);
    EXPECT_FALSE(simulation.parameters().is_given("water.sea_level"));
    simulation.apply(SetParameter{"water.sea_level", 20.0});
    Simulation straight(coast(), Parameters(simulation_parameters()));
    straight.apply(SetParameter{"water.sea_level", 20.0});
    EXPECT_EQ(hash_of(simulation), hash_of(straight));
}

TEST(WaterSimulation, AWaveMakerBeginsWhenItIsSet) {
    const gpu::Context context;
    Parameters all(simulation_parameters());
    for (const char* assignment : {"time.tick_s=1", "water.sea_level=45", "water.wave=solitary",
                                   "water.wave_height=3", "water.wave_depth=15", "water.boundary.west=wall"})
        all.set_assignment(assignment);
    Simulation simulation(coast(), all);
    simulation.apply(Ticks{200});
    simulation.apply(SetParameter{"water.boundary.west", std::string("wave")});
    double highest = 0;
    for (int i = 0; i < 40; ++i) {
        simulation.apply(Ticks{1});
        highest = std::max(highest, read_gauge(simulation.terrain(), 100, 1200).level_m());
    }
    EXPECT_GT(highest, 46.5) << "the wave of 3 m must come, though 200 s are past";
}

TEST_P(EitherOrder, FrameRateReplayAndSavingMidwayChangeNoBit) {
    const gpu::Context context;
    Parameters parameters_here = parameters();
    parameters_here.set("water.order", GetParam());
    parameters_here.set("time.tick_s", 2.0);
    const auto play = [](Simulation& simulation, int first, int last, int substeps) {
        std::mt19937 random(static_cast<unsigned>(first));
        for (int tick = first; tick < last; ++tick) {
            if (tick % 5 == 0) simulation.apply(water_dab(random));
            if (tick % 5 == 1) simulation.apply(paint_dab(random));
            if (tick == 12) simulation.apply(SetParameter{"water.rain_over", std::string("mask")});
            if (tick == 4) simulation.apply(PlaceSpring{700, 1300, 50});
            while (!simulation.advance(substeps)) {
            }
        }
    };
    Simulation at_15(coast(), parameters_here);
    play(at_15, 0, 10, 1 << 20);
    play(at_15, 10, 30, 1 << 20);
    // A frame of 1/144 s has room for fewer sub-steps than one of 1/30 s.
    Simulation at_30(coast(), parameters_here);
    play(at_30, 0, 10, 3);
    play(at_30, 10, 30, 3);
    Simulation at_144(coast(), parameters_here, undo_bytes);
    play(at_144, 0, 10, 1);
    play(at_144, 10, 30, 1);
    EXPECT_EQ(hash_of(at_15), hash_of(at_30));
    EXPECT_EQ(hash_of(at_15), hash_of(at_144));
    EXPECT_GT(at_15.work("water").substeps, 60U) << "ticks must have had several sub-steps";

    // Through a file.
    Simulation first(coast(), parameters_here);
    play(first, 0, 10, 2);
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / ("talus_water_" + std::to_string(::getpid()) + ".exr");
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
    play(second, 10, 30, 2);
    EXPECT_EQ(hash_of(at_15), hash_of(second));

    const std::string text = write_journal({"", "", "{}", 0}, at_15.journal());
    Simulation replayed(coast(), parameters_here);
    for (const Operation& operation : read_journal(text, "journal").operations) replayed.apply(operation);
    EXPECT_EQ(hash_of(at_15), hash_of(replayed));
}

TEST(WaterSimulation, TheBooksClose) {
    const gpu::Context context;
    for (const int order : {1, 2}) {
        Parameters all = parameters();
        all.set("water.order", order);
        Simulation simulation(coast(), all);
        std::mt19937 random(3);
        simulation.apply(PlaceSpring{700, 1300, 50});
        for (int i = 0; i < 40; ++i) {
            simulation.apply(water_dab(random));
            if (i > 10) simulation.apply(paint_dab(random));
            if (i == 20) simulation.apply(SetParameter{"water.rain_over", std::string("mask")});
            simulation.apply(Ticks{3});
        }
        simulation.apply(SetParameter{"water.sea_level", 50.0});
        simulation.apply(Ticks{10});
        const LedgerReading ledger = simulation.ledger();
        EXPECT_GT(ledger.water_initial, 1e7);
        EXPECT_GT(ledger.water_in, 1e6);
        EXPECT_GT(ledger.water_out, 1e5);
        // Against what came and went, which is far less than what is there.
        const double missing = ledger.water_final - ledger.water_initial - ledger.water_in + ledger.water_out;
        EXPECT_LE(std::abs(missing), 1e-6 * (ledger.water_in + ledger.water_out)) << "order " << order;
    }
}

TEST(WaterSimulation, KeepsTheLargestDepthAndWhenItCame) {
    const gpu::Context context;
    TerrainState start = coast();
    start.water.assign(grid.count(), glm::vec4(0));
    for (std::size_t i = 0; i < grid.count(); ++i) start.water[i].x = std::max(0.0F, 30 - start.bedrock[i].x);
    Simulation simulation(start, parameters(), undo_bytes);
    std::vector<glm::vec2> expected(grid.count(), glm::vec2(0));
    std::mt19937 random(5);
    const auto follow = [&] {
        const TerrainState now = simulation.read();
        for (std::size_t i = 0; i < grid.count(); ++i) {
            const float depth = now.water[i].x;
            if (depth < 0.01F || depth <= expected[i].x) continue;
            if (expected[i].x == 0) expected[i].y = static_cast<float>(now.clock.simulated_s);
            expected[i].x = depth;
        }
    };
    follow();
    for (int i = 0; i < 25; ++i) {
        if (i % 6 == 2) simulation.apply(water_dab(random));
        follow();
        simulation.apply(Ticks{1});
        follow();
    }
    EXPECT_EQ(simulation.read().inundation, expected);
    std::size_t late = 0;
    for (const glm::vec2& sample : expected) late += sample.y > 1 ? 1 : 0;
    EXPECT_GT(late, grid.count() / 20) << "water must have reached new ground";
}

// What a brush painted falls there and nowhere else, and by the mask as much as it says.
TEST(WaterSimulation, RainFallsWhereItWasPainted) {
    const gpu::Context context;
    const Grid plain{130, 70, 10, 10};
    Parameters all(simulation_parameters());
    for (const char* assignment : {"time.tick_s=1", "water.boundary.north=wall", "water.boundary.south=wall",
                                   "water.boundary.west=wall", "water.boundary.east=wall"})
        all.set_assignment(assignment);
    Simulation simulation(bedrock_terrain(plain, std::vector<float>(plain.count(), 5.0F)), all);
    Dab dab;
    dab.x_m = 300;
    dab.y_m = 350;
    dab.radius_m = 120;
    dab.falloff = 0;
    dab.blend = 1;
    dab.target_m = 360;
    dab.material = Material::rain;
    simulation.apply(dab);
    simulation.apply(Ticks{1});
    const std::vector<glm::vec4> fallen = simulation.read().water;
    std::size_t wet = 0;
    for (std::size_t i = 0; i < plain.count(); ++i) {
        const auto row = static_cast<int>(i / 130);
        const double x = static_cast<double>(i % 130) * 10 - 300;
        const double y = (69 - row) * 10 - 350;
        const float depth = fallen[i].x;
        const bool inside = x * x + y * y < 120 * 120;
        wet += inside ? 1 : 0;
        if (inside)
            EXPECT_NEAR(depth, 1e-4, 1e-9);
        else
            EXPECT_EQ(depth, 0);
        if (testing::Test::HasFailure()) break;
    }
    EXPECT_NEAR(simulation.ledger().water_in, static_cast<double>(wet) * 100 * 1e-4, 1e-6);
    // Wiped, it stops; by a mask of one half, half of it falls.
    dab.effect = LowerDab{};
    dab.target_m = 0;
    simulation.apply(dab);
    const double before = simulation.ledger().water_in;
    simulation.apply(Ticks{10});
    EXPECT_EQ(simulation.ledger().water_in, before);
    dab.effect = RaiseDab{};
    dab.material = Material::mask;
    dab.target_m = 0.5;
    simulation.apply(dab);
    simulation.apply(SetParameter{"water.rain_over", std::string("mask")});
    simulation.apply(SetParameter{"water.rain", 720.0});
    simulation.apply(Ticks{10});
    EXPECT_NEAR(simulation.ledger().water_in - before, static_cast<double>(wet) * 100 * 1e-3, 1e-5);
    EXPECT_LE(std::abs(simulation.ledger().water_drift_relative()), 1e-6);
    dab.target_m = 1.5;
    EXPECT_THROW(simulation.apply(dab), Error);
}

TEST(WaterSimulation, TheSeaFillsWhatTheEdgeReaches) {
    TerrainState state = bedrock_terrain({7, 5, 10, 10}, std::vector<float>(35, 8.0F));
    const auto at = [](int column, int row) { return static_cast<std::size_t>(row) * 7 + column; };
    // A bay from the western edge, and a hollow that walls keep dry.
    for (int column = 0; column < 3; ++column) state.bedrock[at(column, 2)].x = 1;
    state.bedrock[at(5, 2)].x = 1;
    const double gained = fill_sea(state, 4);
    EXPECT_EQ(gained, 3 * 3 * 100.0);
    EXPECT_EQ(state.water[at(2, 2)].x, 3);
    EXPECT_EQ(state.water[at(5, 2)].x, 0);
    EXPECT_EQ(fill_sea(state, 4), 0) << "it is full";

    // Beyond the bay's mouth lies a dike; where that is lower, or not known, the sea comes in.
    for (const auto& [beyond_m, expected_m3] :
         {std::pair(6.0F, 0.0), {2.0F, 900.0}, {glsl::unknown_bed, 900.0}}) {
        state.water.clear();
        state.bed_beyond = bed_beyond_of(state.grid, [beyond_m = beyond_m](glm::ivec2) { return beyond_m; });
        EXPECT_EQ(fill_sea(state, 4), expected_m3) << beyond_m;
    }
}

TEST(WaterSimulation, NoWaterCostsNothingAndWaterOffStandsStill) {
    const gpu::Context context;
    Simulation dry(coast(), Parameters(simulation_parameters()));
    dry.apply(Ticks{3});
    EXPECT_FALSE(dry.terrain().water.has_value());
    Parameters off = parameters();
    Simulation flowing(coast(), off);
    flowing.apply(Ticks{3});
    flowing.apply(SetParameter{"water.on", false});
    const std::vector<glm::vec4> before = flowing.read().water;
    flowing.apply(Ticks{3});
    EXPECT_EQ(before, flowing.read().water);
}

TEST(WaterSimulation, SaysHowTrueItsWavesAre) {
    // kd = 0.1: c² differs by (kd)²/3, c by (kd)²/6. Deep water: c = g T / 2π.
    const double d = 10;
    const double k = 0.1 / d;
    const double omega = std::sqrt(9.81 * k * std::tanh(k * d));
    EXPECT_NEAR(shallow_speed_excess(d, 2 * std::acos(-1.0) / omega, 9.81), 0.01 / 6, 1e-5);
    const double deep = std::sqrt(9.81 * 1000.0) / (9.81 * 5 / (2 * std::acos(-1.0))) - 1;
    EXPECT_NEAR(shallow_speed_excess(1000, 5, 9.81), deep, 1e-6 * deep);
    Parameters all = parameters();
    all.set("water.wave_period", 300.0);
    EXPECT_NE(app::wave_note(coast(), all).find("faster than in nature"), std::string::npos);
    EXPECT_EQ(app::wave_note(coast(), all).find("warning"), std::string::npos);
    all.set("water.wave_period", 4.0);
    EXPECT_EQ(app::wave_note(coast(), all).find("warning"), 0U);
    all.set("water.boundary.west", std::string("wall"));
    EXPECT_EQ(app::wave_note(coast(), all), "");
}

TEST(WaterSimulation, GaugesFollowWithoutWaitingWhatTheyReadByWaiting) {
    const gpu::Context context;
    Simulation simulation(coast(), parameters(), undo_bytes);
    app::Gauges waiting(grid);
    app::Gauges following(grid);
    for (app::Gauges* gauges : {&waiting, &following}) {
        gauges->place({200, 1200});
        gauges->place({1500, 900});
    }
    for (int tick = 0; tick < 20; ++tick) {
        if (tick == 12) {
            waiting.place({2400, 400});
            following.place({2400, 400});
        }
        simulation.apply(Ticks{1});
        waiting.record(simulation.terrain(), simulation.clock().simulated_s);
        // It asks, and takes what has come in a later frame.
        EXPECT_TRUE(wait_until([&] {
            following.follow(simulation.terrain(), simulation.clock().simulated_s);
            return following.times_s().size() == waiting.times_s().size();
        }));
    }
    EXPECT_EQ(waiting.to_csv(), following.to_csv());
    EXPECT_NE(waiting.to_csv().find(",,,\n"), std::string::npos) << "the third was placed later";
    simulation.end_entry();
    simulation.undo();
    following.follow(simulation.terrain(), simulation.clock().simulated_s);
    for (const double time_s : following.times_s()) EXPECT_LE(time_s, simulation.clock().simulated_s);
    // Nor does a row come that was asked for before undo went back.
    simulation.apply(Ticks{2});
    EXPECT_TRUE(wait_until([&] {
        following.follow(simulation.terrain(), simulation.clock().simulated_s);
        return !following.times_s().empty() && following.times_s().back() == simulation.clock().simulated_s;
    }));
    const std::vector<double> times_s = following.times_s();
    simulation.end_entry();
    simulation.apply(Ticks{1});
    following.follow(simulation.terrain(), simulation.clock().simulated_s);
    simulation.undo();
    for (int i = 0; i < 100; ++i) {
        following.follow(simulation.terrain(), simulation.clock().simulated_s);
        ASSERT_EQ(following.times_s(), times_s);
    }
    EXPECT_THROW(following.place({-5, 3}), Error);
}

// Five seconds of play change the first look at it, as a person sees. The simulated time is what a window on
// two cores, one of them busy with something else, got to in them.
TEST(WaterSimulationPresets, AreSeenToMoveWithinFiveSeconds) {
    const gpu::Context context;
    for (const auto& [preset, played_s] : {std::pair("flood", 38.0), std::pair("island", 4.5)}) {
        app::SceneRequest request;
        request.preset = preset;
        const app::Scene scene = make_scene(request);
        Simulation simulation(scene.document.state, scene.simulation);
        render::Renderer renderer(simulation.terrain(), 8);
        const render::Camera camera =
            render::overview(scene.document.state.grid, 0, scene.simulation.number("terrain.relief_m"));
        const render::ViewSettings settings = render::view_settings(scene.view, scene.simulation);
        const auto look = [&] {
            renderer.draw(simulation.terrain(), camera, settings, 640, 360);
            return renderer.read_rgb(640, 360);
        };
        const std::vector<std::uint8_t> before = look();
        simulation.apply(Ticks{static_cast<std::int64_t>(played_s / scene.simulation.number("time.tick_s"))});
        const std::vector<std::uint8_t> after = look();
        std::size_t changed = 0;
        for (std::size_t i = 0; i < before.size(); i += 3)
            if (std::max({std::abs(before[i] - after[i]), std::abs(before[i + 1] - after[i + 1]),
                          std::abs(before[i + 2] - after[i + 2])}) > 12)
                ++changed;
        const double share = 3.0 * static_cast<double>(changed) / static_cast<double>(before.size());
        fmt::print("{}: {:.2f} % of the picture changed\n", preset, 100 * share);
        EXPECT_GT(share, 0.002) << preset;
    }
}

TEST(WaterSimulation, RefusesSpringsOffTheMap) {
    const gpu::Context context;
    Simulation simulation(coast(), parameters());
    EXPECT_THROW(simulation.apply(PlaceSpring{-1, 5, 1}), Error);
    EXPECT_THROW(simulation.apply(PlaceSpring{5, 1e9, 1}), Error);
    EXPECT_THROW(simulation.apply(PlaceSpring{5, 5, -1}), Error);
    EXPECT_THROW(simulation.apply(PlaceSpring{5, 5, std::nan("")}), Error);
    EXPECT_TRUE(simulation.springs().empty());
}

}  // namespace
}  // namespace talus::water_simulation_test

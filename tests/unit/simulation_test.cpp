// What a session relies on: undo to the bit, replay, rest, the ledger.
#include <gtest/gtest.h>

#include <random>

#include "sim/error.h"
#include "sim/gpu/context.h"
#include "sim/preset.h"
#include "sim/simulation.h"
#include "sim/simulation_parameters.h"
#include "sim/terrain/generate.h"
#include "sim/terrain/state_hash.h"

namespace talus::simulation_test {
namespace {

constexpr std::size_t undo_bytes = 256U << 20U;
const Grid grid{200, 137, 20, 25};

TerrainState mountains() {
    return bedrock_terrain(grid, generate_heights(grid, {"mountains", 5, 1500}));
}
Parameters parameters() {
    return Parameters(simulation_parameters());
}

Dab random_dab(std::mt19937& random) {
    std::uniform_real_distribution<double> unit(0, 1);
    Dab dab;
    dab.effect = effect_of(static_cast<BrushMode>(random() % 4));
    dab.x_m = grid.width_m() * unit(random);
    dab.y_m = grid.height_m() * unit(random);
    dab.radius_m = 30 + 500 * unit(random);
    dab.falloff = unit(random);
    dab.amount_m = 50 * unit(random);
    dab.blend = unit(random);
    dab.target_m = 1000 * unit(random);
    dab.material = random() % 2 == 0 ? Material::regolith : Material::bedrock;
    return dab;
}

std::uint64_t hash_of(const Simulation& simulation) {
    return state_hash(simulation.read());
}

TEST(Simulation, UndoesAndRedoesStrokesRunsAndParametersToTheBit) {
    const gpu::Context context;
    Simulation simulation(mountains(), parameters(), undo_bytes);
    std::mt19937 random(17);
    std::vector<std::uint64_t> hashes = {hash_of(simulation)};
    std::vector<LedgerReading> ledgers = {simulation.ledger()};
    for (int entry = 0; entry < 12; ++entry) {
        if (entry % 3 == 0) {
            simulation.begin_stroke("raise");
            for (int i = 0; i < 5; ++i) {
                simulation.apply(random_dab(random));
                if (entry % 2 == 0) simulation.apply(Ticks{2});
            }
            simulation.end_entry();
        } else if (entry % 3 == 1) {
            simulation.apply(Ticks{7});
            simulation.end_entry();
        } else {
            simulation.apply(SetParameter{"thermal.repose_deg", 25.0 + entry});
        }
        hashes.push_back(hash_of(simulation));
        ledgers.push_back(simulation.ledger());
    }
    const std::vector<Operation> all = simulation.journal().operations();
    for (int entry = 11; entry >= 0; --entry) {
        ASSERT_TRUE(simulation.can_undo());
        simulation.undo();
        EXPECT_EQ(hash_of(simulation), hashes[entry]) << "entry " << entry;
        EXPECT_DOUBLE_EQ(simulation.ledger().solid_in, ledgers[entry].solid_in);
    }
    EXPECT_FALSE(simulation.can_undo());
    EXPECT_TRUE(simulation.journal().operations().empty());
    for (int entry = 0; entry < 12; ++entry) {
        simulation.redo();
        EXPECT_EQ(hash_of(simulation), hashes[entry + 1]) << "entry " << entry;
    }
    EXPECT_FALSE(simulation.can_redo());
    EXPECT_EQ(simulation.journal().operations(), all);
}

TEST(Simulation, ASliderThatIsDraggedIsOneEntryAndAnEmptyStrokeNone) {
    const gpu::Context context;
    Simulation simulation(mountains(), parameters(), undo_bytes);
    for (int i = 0; i < 30; ++i) simulation.apply(SetParameter{"thermal.repose_deg", 20.0 + i});
    simulation.begin_stroke("raise");
    simulation.end_entry();
    simulation.undo();
    EXPECT_EQ(simulation.parameters().number("thermal.repose_deg"), 33);
    EXPECT_FALSE(simulation.can_undo());
    simulation.redo();
    EXPECT_EQ(simulation.parameters().number("thermal.repose_deg"), 49);
}

// What was unset follows again what it follows, in undo, in the journal and in a saved document too.
TEST(Simulation, WhatIsUnsetFollowsAgain) {
    const gpu::Context context;
    Simulation simulation(mountains(), parameters(), undo_bytes);
    const auto bedrock_deg = [](const Simulation& s) { return s.parameters().number("thermal.bedrock_deg"); };
    const double natural = simulation.parameters().number("thermal.rate_m2_per_s");
    simulation.apply(SetParameter{"thermal.bedrock_deg", 60.0});
    simulation.apply(SetParameter{"thermal.repose_deg", 25.0});
    EXPECT_EQ(bedrock_deg(simulation), 60);
    simulation.apply(SetParameter{"thermal.bedrock_deg", std::nullopt});
    EXPECT_EQ(bedrock_deg(simulation), 25);
    simulation.apply(SetParameter{"thermal.repose_deg", 28.0});
    EXPECT_EQ(bedrock_deg(simulation), 28);
    simulation.apply(SetParameter{"thermal.repose_deg", std::nullopt});
    EXPECT_EQ(bedrock_deg(simulation), 33);
    simulation.apply(SetParameter{"thermal.rate_m2_per_s", natural / 10});
    simulation.apply(SetParameter{"thermal.rate_m2_per_s", std::nullopt});
    EXPECT_EQ(simulation.parameters().number("thermal.rate_m2_per_s"), natural);

    Simulation replayed(mountains(), parameters());
    for (const Operation& operation : read_journal(write_journal({}, simulation.journal()), "j").operations)
        replayed.apply(operation);
    EXPECT_EQ(replayed.parameters(), simulation.parameters());
    EXPECT_FALSE(replayed.parameters().is_given("thermal.bedrock_deg"));

    // Saved and read again, it follows still.
    simulation.apply(SetParameter{"thermal.repose_deg", 40.0});
    Parameters read = parameters();
    from_toml(to_toml(simulation.parameters()), "document", read);
    Simulation reopened(simulation.read(), read, undo_bytes);
    EXPECT_EQ(reopened.parameters(), simulation.parameters());
    reopened.apply(SetParameter{"thermal.repose_deg", 45.0});
    EXPECT_EQ(bedrock_deg(reopened), 45);

    for (int i = 0; i < 3; ++i) simulation.undo();
    EXPECT_EQ(bedrock_deg(simulation), 25);
    EXPECT_FALSE(simulation.parameters().is_given("thermal.bedrock_deg"));
}

// Porosity set on the way and porosity from the start make the same of what follows it.
TEST(Simulation, TheRateOfSlopesFollowsThePorosityWheneverItIsSet) {
    const gpu::Context context;
    const auto rate = [](const Simulation& s) { return s.parameters().number("thermal.rate_m2_per_s"); };
    Simulation simulation(mountains(), parameters());
    const double solid = rate(simulation);
    simulation.apply(SetParameter{"erosion.porosity", 0.6});
    Parameters porous = parameters();
    porous.set("erosion.porosity", 0.6);
    EXPECT_EQ(rate(simulation), rate(Simulation(mountains(), porous)));
    EXPECT_NE(rate(simulation), solid);
    simulation.apply(SetParameter{"thermal.rate_m2_per_s", solid});
    simulation.apply(SetParameter{"erosion.porosity", 0.3});
    EXPECT_EQ(rate(simulation), solid) << "what was set stays";
}

TEST(Simulation, RefusesRatesThatNoTickCanRun) {
    const gpu::Context context;
    Simulation simulation(mountains(), parameters(), undo_bytes);
    EXPECT_THROW(simulation.apply(SetParameter{"thermal.rate_m2_per_s", 1e12}), Error);
    EXPECT_NO_THROW(simulation.apply(Ticks{1}));
}

TEST(Simulation, HistoryShowsWhatWasSetToWhat) {
    const gpu::Context context;
    Simulation simulation(mountains(), parameters(), undo_bytes);
    simulation.apply(SetParameter{"thermal.wet_deg", 20.0});
    // A slider that is dragged goes on in one entry, which says where it stands.
    for (const double angle_deg : {30.0, 28.5, 25.0})
        simulation.apply(SetParameter{"thermal.wet_deg", angle_deg});
    simulation.apply(SetParameter{"water.boundary.north", std::string("wall")});
    simulation.apply(SetParameter{"erosion.on", true});
    simulation.apply(SetParameter{"erosion.on", std::nullopt});
    const std::vector<std::string> wanted = {"Angle under water: 25 °", "Northern edge: Wall",
                                             "Water erodes: as by default"};
    EXPECT_EQ(simulation.undo_history().done(), wanted);
    simulation.apply(SetParameter{"time.tick_s", 0.5});
    simulation.apply(Ticks{5});
    simulation.end_entry();
    EXPECT_EQ(simulation.undo_history().undo_name(), "run of 2.5 s");
    while (simulation.can_undo()) simulation.undo();
    EXPECT_EQ(simulation.parameters(), Simulation(mountains(), parameters()).parameters());
}

TEST(Simulation, ANewStrokeDropsTheRedo) {
    const gpu::Context context;
    Simulation simulation(mountains(), parameters(), undo_bytes);
    std::mt19937 random(1);
    simulation.begin_stroke("raise");
    simulation.apply(random_dab(random));
    simulation.end_entry();
    simulation.undo();
    EXPECT_TRUE(simulation.can_redo());
    simulation.begin_stroke("lower");
    EXPECT_FALSE(simulation.can_redo());
}

TEST(Simulation, UndoKeepsUnderItsCap) {
    const gpu::Context context;
    const std::size_t cap = 2U << 20U;
    Simulation simulation(mountains(), parameters(), cap);
    std::mt19937 random(2);
    for (int i = 0; i < 40; ++i) {
        simulation.begin_stroke("raise");
        simulation.apply(random_dab(random));
        simulation.end_entry();
        simulation.settle_undo();
        EXPECT_LE(simulation.undo_history().bytes(), cap);
    }
    EXPECT_TRUE(simulation.can_undo());
}

TEST(Simulation, ReplayOfItsJournalGivesTheSameBits) {
    const gpu::Context context;
    Simulation live(mountains(), parameters(), undo_bytes);
    std::mt19937 random(23);
    for (int i = 0; i < 20; ++i) {
        live.begin_stroke("stroke");
        live.apply(random_dab(random));
        // In parts, as a window runs ticks.
        while (!live.advance(1)) {
        }
        live.end_entry();
        if (i % 4 == 1) live.undo();
        if (i % 8 == 1) live.redo();
        if (i == 9) live.apply(SetParameter{"thermal.repose_deg", 28.0});
    }
    const std::string text = write_journal({"", "", "{}", 0}, live.journal());
    Simulation replayed(mountains(), parameters());
    for (const Operation& operation : read_journal(text, "journal").operations) replayed.apply(operation);
    EXPECT_EQ(hash_of(live), hash_of(replayed));
}

TEST(Simulation, SavedMidwayAndContinuedGivesTheSameBits) {
    const gpu::Context context;
    Simulation whole(mountains(), parameters());
    whole.apply(Ticks{60});
    Simulation first(mountains(), parameters());
    first.apply(Ticks{23});
    Simulation second(first.read(), first.parameters());
    second.apply(Ticks{37});
    EXPECT_EQ(hash_of(whole), hash_of(second));
}

TEST(Simulation, SleepingTilesChangeNothing) {
    const gpu::Context context;
    // A lone steep hill on a plain: most tiles sleep. Waking all of them every tick must not change a bit.
    const Grid wide{400, 400, 10, 10};
    std::vector<float> heights(wide.count(), 0.0F);
    for (int y = 150; y < 190; ++y)
        for (int x = 170; x < 200; ++x) heights[static_cast<std::size_t>(y) * wide.nx + x] = 300;
    Simulation sparse(bedrock_terrain(wide, heights), parameters());
    Simulation dense(bedrock_terrain(wide, heights), parameters());
    Tiles::Reader before_last;
    for (int i = 0; i < 200; ++i) {
        before_last = sparse.terrain().tiles.reader_now();
        sparse.apply(Ticks{1});
        dense.terrain().tiles.mark_all();
        dense.apply(Ticks{1});
    }
    EXPECT_EQ(hash_of(sparse), hash_of(dense));
    EXPECT_GT(sparse.ledger().moved_m3(), 1e5);
    // And they did sleep: tiles far from the hill were not active in the last tick.
    const std::vector<bool> active = sparse.terrain().tiles.read(Tiles::ground, before_last);
    EXPECT_LT(std::count(active.begin(), active.end(), true), static_cast<std::ptrdiff_t>(active.size() / 2));
}

TEST(Simulation, TurnedTerrainGivesTurnedBits) {
    const gpu::Context context;
    const Grid square{129, 129, 15, 15};
    const std::vector<float> heights = generate_heights(square, {"mountains", 8, 900});
    std::vector<float> turned(heights.size());
    const int n = square.nx;
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x)
            turned[static_cast<std::size_t>(x) * n + (n - 1 - y)] =
                heights[static_cast<std::size_t>(y) * n + x];
    Simulation straight(bedrock_terrain(square, heights), parameters());
    Simulation rotated(bedrock_terrain(square, turned), parameters());
    straight.apply(Ticks{100});
    rotated.apply(Ticks{100});
    const TerrainState a = straight.read();
    const TerrainState b = rotated.read();
    int different = 0;
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            const std::size_t from = static_cast<std::size_t>(y) * n + x;
            const std::size_t to = static_cast<std::size_t>(x) * n + (n - 1 - y);
            different += a.bedrock[from] != b.bedrock[to] || a.regolith[from] != b.regolith[to] ? 1 : 0;
        }
    EXPECT_EQ(different, 0);
}

TEST(Simulation, LedgerClosesWithBrushAndErosion) {
    const gpu::Context context;
    Simulation simulation(mountains(), parameters());
    std::mt19937 random(31);
    for (int i = 0; i < 50; ++i) {
        simulation.apply(random_dab(random));
        simulation.apply(Ticks{3});
    }
    const LedgerReading ledger = simulation.ledger();
    EXPECT_GT(ledger.solid_in, 0);
    EXPECT_GT(ledger.solid_out, 0);
    EXPECT_GT(ledger.moved_m3(), 1e6);
    EXPECT_LE(ledger.closing_error_of_moved(), 1e-6);
}

TEST(Simulation, IncrementsBelowOneUlpAddUp) {
    const gpu::Context context;
    const Grid flat{8, 8, 10, 10};
    Simulation simulation(bedrock_terrain(flat, std::vector<float>(flat.count(), 4000.0F)), parameters());
    Dab dab;
    dab.x_m = dab.y_m = 35;
    dab.radius_m = 1000;
    dab.falloff = 0;
    dab.amount_m = 1e-7;
    for (int i = 0; i < 10000; ++i) simulation.apply(dab);
    const TerrainState state = simulation.read();
    EXPECT_NEAR(static_cast<double>(state.bedrock[27].x) - 4000 + state.bedrock[27].y, 1e-3, 1e-8);
}

TEST(Simulation, RefusesWhatCannotBeSetAndChangesNothing) {
    const gpu::Context context;
    Simulation simulation(mountains(), parameters(), undo_bytes);
    const std::uint64_t before = hash_of(simulation);
    EXPECT_THROW(simulation.apply(SetParameter{"thermal.repose_deg", 300.0}), Error);
    EXPECT_THROW(simulation.apply(SetParameter{"thermal.unknown", 1.0}), Error);
    EXPECT_TRUE(simulation.journal().operations().empty());
    EXPECT_FALSE(simulation.can_undo());
    EXPECT_EQ(hash_of(simulation), before);
}

}  // namespace
}  // namespace talus::simulation_test

// What happens by itself at a time: parameters that are set, and breaches; undo, files and replay change no
// bit.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "app/core/scene.h"
#include "sim/error.h"
#include "sim/events.h"
#include "sim/gpu/context.h"
#include "sim/io/document.h"
#include "sim/journal.h"
#include "sim/preset.h"
#include "sim/simulation.h"
#include "sim/simulation_parameters.h"
#include "sim/terrain/reshape.h"
#include "sim/terrain/state_hash.h"
#include "tests/scenes/parameters_with.h"
#include "tests/scenes/undo_trail.h"

namespace talus::events_test {
namespace {

constexpr std::size_t undo_bytes = 256U << 20U;
const Grid grid{90, 60, 5, 5};

std::uint64_t hash_of(const Simulation& simulation) {
    return state_hash(simulation.read());
}

// A lake behind a dam 20 m high, across columns 40 to 44.
TerrainState dammed() {
    std::vector<float> heights;
    for (int row = 0; row < grid.ny; ++row)
        for (int column = 0; column < grid.nx; ++column)
            heights.push_back(column >= 40 && column <= 44 ? 120.0F
                                                           : 100.0F - 0.05F * static_cast<float>(column));
    TerrainState state = bedrock_terrain(grid, heights);
    state.water.assign(grid.count(), glm::vec4(0));
    for (std::size_t i = 0; i < grid.count(); ++i)
        if (i % 90 < 40) state.water[i].x = 115 - state.bedrock[i].x;
    return state;
}

Event breach_at(double at_s, double over_s) {
    return {at_s, "", Breach{{185, 150}, {240, 150}, 30, 120, 104, 2, over_s}};
}

Parameters quiet(std::initializer_list<const char*> more = {}) {
    Parameters all = parameters_with({"time.tick_s=2", "thermal.on=false"});
    for (const char* assignment : more) all.set_assignment(assignment);
    return all;
}

TEST(Events, SetParametersAtTheirTime) {
    const gpu::Context context;
    TerrainState state = bedrock_terrain(grid, std::vector<float>(grid.count(), 0));
    state.events = {
        {10, "water.rain=72"},           {20, "water.rain_mm_per_h=0"},    {5, "water.boundary.east=wall"},
        {5, "water.boundary.west=wall"}, {5, "water.boundary.north=wall"}, {5, "water.boundary.south=wall"}};
    Simulation simulation(state, quiet());
    simulation.apply(Ticks{4});
    EXPECT_EQ(simulation.parameters().choice("water.boundary.east"), "wall");
    EXPECT_EQ(simulation.ledger().water_in, 0);
    simulation.apply(Ticks{26});
    // From 10 s to 20 s.
    const double wanted_m3 = 10 * 72e-3 / 3600 * 25 * static_cast<double>(grid.count());
    EXPECT_NEAR(simulation.ledger().water_in / wanted_m3, 1, 1e-5);
    EXPECT_EQ(simulation.parameters().number("water.rain_mm_per_h"), 0);
    for (const Event& event : simulation.events()) EXPECT_TRUE(event.done) << name_of(event);
    // What somebody sets afterwards stays.
    simulation.apply(SetParameter{"water.rain_mm_per_h", 5.0});
    simulation.apply(Ticks{2});
    EXPECT_EQ(simulation.parameters().number("water.rain_mm_per_h"), 5);
}

TEST(Events, SetWhatFollowedATable) {
    const gpu::Context context;
    TerrainState state = bedrock_terrain(grid, std::vector<float>(grid.count(), 0));
    state.events = {{10, "water.rain=0"}};
    Simulation simulation(state, quiet());
    simulation.apply(DriveParameter{"water.rain", TimeSeries({{0, 50}, {1000, 50}})});
    simulation.apply(Ticks{20});
    EXPECT_TRUE(simulation.drives().empty());
    const double wanted_m3 = 10 * 50e-3 / 3600 * 25 * static_cast<double>(grid.count());
    EXPECT_NEAR(simulation.ledger().water_in / wanted_m3, 1, 1e-5);
}

TEST(Events, ABreachLetsTheLakeOut) {
    const gpu::Context context;
    TerrainState state = dammed();
    state.events = {breach_at(20, 40)};
    Simulation simulation(state, quiet({"maps.count=always"}));
    simulation.apply(Ticks{10});
    EXPECT_EQ(simulation.read().ground(), state.ground()) << "not before its time";
    simulation.apply(Ticks{10});
    // Half of it: 8 m deep, 15 m wide.
    const auto ground_at = [&](int column, int row) {
        return simulation.read().ground()[static_cast<std::size_t>(row) * grid.nx + column];
    };
    // The map's row 29 lies 150 m north.
    EXPECT_NEAR(ground_at(42, 29), 120 - 16 * 18.0 / 40, 1e-4) << "the last tick began at 38 s";
    simulation.apply(Ticks{20});
    EXPECT_NEAR(ground_at(42, 29), 104, 1e-4);
    EXPECT_NEAR(ground_at(42, 26), 104, 1e-4) << "15 m beside the line";
    EXPECT_NEAR(ground_at(42, 25), 104 + 2 * 5, 1e-4) << "5 m further up its side";
    EXPECT_EQ(ground_at(42, 24), 120) << "8 m are as far as its side goes";
    const TerrainState end = simulation.read();
    const std::vector<float> before = state.ground();
    const std::vector<float> after = end.ground();
    for (int row = 0; row < grid.ny; ++row)
        for (int column = 0; column < grid.nx; ++column) {
            const auto i = static_cast<std::size_t>(row) * grid.nx + column;
            EXPECT_LE(after[i], before[i]);
            const bool is_far = column < 30 || column > 55;
            EXPECT_TRUE(!is_far || after[i] == before[i]) << column << " " << row;
        }
    EXPECT_GT(end.water[29U * 90 + 60].x, 0.5) << "the flood is below the dam";
    const LedgerReading ledger = simulation.ledger();
    EXPECT_NEAR(ledger.solid_out / ledger.eroded_m3, 1, 1e-6) << "what it took is booked";
    EXPECT_LT(std::abs(ledger.closing_error_of_moved()), 1e-6);
}

TEST(Events, UndoFilesAndReplayChangeNoBit) {
    const gpu::Context context;
    TerrainState state = dammed();
    state.events = {breach_at(12, 30), {20, "water.manning=0.1"}, {30, "water.boundary.east=wall"}};
    Simulation straight(state, quiet({"erosion.on=true"}));
    straight.apply(Ticks{30});
    const auto act = [](Simulation& of) {
        return [&of](int number) {
            of.apply(number == 2 ? Operation(SetParameter{"water.rain", 20.0}) : Operation(Ticks{7}));
            of.end_entry();
        };
    };
    Simulation undone(state, quiet({"erosion.on=true"}), undo_bytes);
    expect_undo_leads_back_and_forth(
        undone, 5, act(undone),
        [](const LedgerReading& a, const LedgerReading& b) { EXPECT_EQ(a.solid_out, b.solid_out); });
    // Saved while it opens, and after.
    for (const std::int64_t until : {3, 8, 13, 25}) {
        Simulation before(state, quiet({"erosion.on=true"}));
        before.apply(Ticks{until});
        const std::filesystem::path path =
            std::filesystem::temp_directory_path() / fmt::format("talus_events_{}.exr", ::getpid());
        io::save_document(path, {before.read(), to_toml(before.parameters()), "", {}});
        const io::Document read = io::open_document(path, {});
        Parameters parameters((simulation_parameters()));
        from_toml(read.parameters, "a document", parameters);
        Simulation after(read.state, parameters);
        after.apply(Ticks{30 - until});
        EXPECT_EQ(hash_of(after), hash_of(straight)) << until;
        std::filesystem::remove(path);
    }
}

TEST(Events, GoWithTheMap) {
    const gpu::Context context;
    TerrainState state = dammed();
    state.events = {breach_at(0, 0), {0, "water.boundary.east=wall"}, {7, "water.rain=1"}};
    Simulation plain(state, quiet());
    plain.apply(Ticks{1});
    Simulation turned_first(state, quiet());
    turned_first.apply(Turn{1});
    turned_first.apply(Ticks{1});
    EXPECT_EQ(turned(plain.read(), 1).ground(), turned_first.read().ground());
    EXPECT_EQ(turned_first.parameters().choice("water.boundary.north"), "wall");
    EXPECT_EQ(turned_first.parameters().choice("water.boundary.east"), "open");
    const Rectangle part = {100, 50, 300, 250};
    Simulation cropped_first(state, quiet());
    cropped_first.apply(Crop{part});
    cropped_first.apply(Ticks{1});
    EXPECT_EQ(cropped(plain.read(), part).ground(), cropped_first.read().ground());
    // What lies beside the part goes.
    Simulation beside(state, quiet());
    beside.apply(Crop{{250, 0, 400, 250}});
    EXPECT_EQ(beside.events().size(), 2U);
    // Another terrain keeps those that lie on it.
    Simulation imported(state, quiet());
    const Grid small{20, 20, 5, 5};
    imported.apply(
        Import{{"/of/a/test.tif", "", 1},
               std::make_shared<TerrainState>(bedrock_terrain(small, std::vector<float>(400, 0)))});
    EXPECT_EQ(imported.events().size(), 2U);
    EXPECT_NO_THROW(Simulation(imported.read(), imported.parameters()));
    // An end on the map's edge stays one at another number of samples.
    TerrainState to_edge = dammed();
    to_edge.events = {{5, "", Breach{{185, 0}, {185, grid.height_m()}, 30, 120, 104, 2, 9}}};
    for (const int ny : {31, 78, 155, 304}) {
        Simulation resampled_one(to_edge, quiet());
        resampled_one.apply(Resample{90, ny});
        EXPECT_NO_THROW(Simulation(resampled_one.read(), resampled_one.parameters())) << ny;
    }
}

TEST(Events, ComeFromScenes) {
    Preset preset;
    preset.name = "flood";
    preset.text = R"(
title = "A flood"
[water]
rain_mm_per_h = 5
[[event]]
at_s = 600
set = "water.rain=0"
[[event]]
at_s = 900.5
breach = { from_m = [185, 150], to_m = [240, 150], width_m = 30, crest_m = 120, bottom_m = 104, over_s = 40 }
)";
    Parameters all(app::make_scene_parameters({}).simulation);
    std::vector<Event> events = events_of(preset);
    ASSERT_EQ(events.size(), 2U);
    check_events(all, grid, events);
    EXPECT_EQ(name_of(events[0]), "600 s: water.rain_mm_per_h=0");
    EXPECT_EQ(events[1].at_s, 900.5);
    EXPECT_EQ(events[1].breach->side_slope, 1);
    events[0].done = true;
    EXPECT_EQ(events_from_text(to_text(events)), events);

    const auto refusal = [&](const std::string& text) -> std::string {
        try {
            Preset other = preset;
            other.text = text;
            std::vector<Event> read = events_of(other);
            check_events(all, grid, read);
        } catch (const Error& error) {
            return error.what();
        }
        ADD_FAILURE() << text << " was taken";
        return "";
    };
    const std::string at = "[[event]]\nat_s = 1\n";
    EXPECT_NE(refusal("[[event]]\nset = \"water.rain=0\"\n").find("at_s"), std::string::npos);
    EXPECT_NE(refusal(at).find("either set"), std::string::npos);
    EXPECT_NE(refusal(at + "set = 7\n").find("either set"), std::string::npos);
    EXPECT_NE(refusal(at + "set = \"water.lava=0\"\n").find("water.lava"), std::string::npos);
    EXPECT_NE(refusal(at + "set = \"water.rain=-3\"\n").find("the event at 1 s is wrong"), std::string::npos);
    EXPECT_NE(refusal(at + "set = \"water.sea_level=3\"\n").find("table"), std::string::npos);
    EXPECT_NE(refusal(at + "set = \"time.tick_s=3\"\n").find("whole run"), std::string::npos);
    EXPECT_NE(refusal("[[event]]\nat_s = -1\nset = \"water.rain=0\"\n").find("at_s cannot be -1"),
              std::string::npos);
    EXPECT_NE(refusal(at + "breach = { from_m = [1, 2], to_m = [3, 4], width_m = 3, bottom_m = 4 }")
                  .find("crest_m"),
              std::string::npos);
    EXPECT_NE(
        refusal(at + "breach = { from_m = [1, 2], to_m = [3, 4], width_m = 3, crest_m = 3, bottom_m = 4 }")
            .find("bottom_m"),
        std::string::npos);
    EXPECT_NE(
        refusal(at + "breach = { from_m = [1, 2], to_m = [3, 4000], width_m = 3, crest_m = 5, bottom_m = 4 }")
            .find("off"),
        std::string::npos);
    EXPECT_NE(refusal(at + "breach = { from_m = [1], to_m = [3, 4], width_m = 3, crest_m = 5, bottom_m = 4 }")
                  .find("from_m must be two numbers"),
              std::string::npos);
    EXPECT_NE(refusal(at + "set = \"water.rain=0\"\nwhen = 3\n").find("when"), std::string::npos);
    EXPECT_THROW(events_from_text("[{}]"), Error);
    EXPECT_THROW(events_from_text("nonsense"), Error);
}

}  // namespace
}  // namespace talus::events_test

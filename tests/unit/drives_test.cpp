// Parameters that follow tables: what they bring is the table's own integral, and undo, replay, files and
// skipping change no bit.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>

#include "app/core/scene.h"
#include "shaders/maths/twin.h"
#include "sim/drives.h"
#include "sim/error.h"
#include "sim/gpu/context.h"
#include "sim/io/document.h"
#include "sim/io/time_series_file.h"
#include "sim/journal.h"
#include "sim/passes/tick_series.h"
#include "sim/passes/water.h"
#include "sim/preset.h"
#include "sim/simulation.h"
#include "sim/simulation_parameters.h"
#include "sim/terrain/generate.h"
#include "sim/terrain/sea.h"
#include "sim/terrain/state_hash.h"
#include "tests/scenes/parameters_with.h"
#include "tests/scenes/undo_trail.h"

namespace talus::drives_test {
namespace {

constexpr std::size_t undo_bytes = 256U << 20U;

// Rows as a gauge writes them: at odd times, many within one of the steps that a tick's tables have.
TimeSeries ragged(unsigned seed, double end_s, double highest) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<TimeSeries::Row> rows = {{0, 0}};
    while (rows.back().time_s < end_s) {
        const double time_s = rows.back().time_s + 0.02 * unit(random) * unit(random);
        rows.push_back({time_s, unit(random) < 0.3 ? 0 : highest * unit(random)});
        // And a jump.
        if (rows.size() % 7 == 0) rows.push_back({time_s, highest * unit(random)});
    }
    return TimeSeries(std::move(rows));
}

std::uint64_t hash_of(const Simulation& simulation) {
    return state_hash(simulation.read());
}

class EitherOrderOfDrives : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Drives, EitherOrderOfDrives, testing::Values(1, 2));

TEST_P(EitherOrderOfDrives, RainBringsItsTablesIntegral) {
    const gpu::Context context;
    const Grid grid{70, 66, 2.5, 2};
    Parameters all =
        parameters_with({"time.tick_s=3", "water.boundary.north=wall", "water.boundary.south=wall",
                         "water.boundary.west=wall", "water.boundary.east=wall"});
    all.set("water.order", GetParam());
    const TimeSeries rain = ragged(5, 70, 9000);
    Simulation simulation(bedrock_terrain(grid, generate_heights(grid, {"hills", 3, 20})), all);
    simulation.apply(DriveParameter{"water.rain", rain});
    simulation.apply(Ticks{20});
    const double wanted =
        rain.integral(0, 60) * 1e-3 / 3600 * grid.dx * grid.dy * static_cast<double>(grid.count());
    const LedgerReading ledger = simulation.ledger();
    fmt::print("rain by a table, order {}: {:.1e} of its integral is missing\n", GetParam(),
               std::abs(ledger.water_in / wanted - 1));
    EXPECT_NEAR(ledger.water_in / wanted, 1, 1e-6);
    EXPECT_NEAR(ledger.water_final / wanted, 1, 1e-6);
    EXPECT_GT(simulation.work("water").substeps, 60U) << "ticks must have had several sub-steps";
}

TEST_P(EitherOrderOfDrives, InflowBringsItsTablesIntegral) {
    const gpu::Context context;
    const Grid grid{90, 66, 5, 4};
    Parameters all =
        parameters_with({"time.tick_s=3", "water.boundary.north=inflow", "water.boundary.south=wall",
                         "water.boundary.west=inflow", "water.boundary.east=wall"});
    all.set("water.order", GetParam());
    const TimeSeries inflow = ragged(6, 70, 400);
    Simulation simulation(bedrock_terrain(grid, generate_heights(grid, {"hills", 3, 4})), all);
    simulation.apply(DriveParameter{"water.inflow_m3_per_s", inflow});
    simulation.apply(Ticks{20});
    const LedgerReading ledger = simulation.ledger();
    fmt::print("inflow by a table, order {}: {:.1e} of its integral is missing\n", GetParam(),
               std::abs(ledger.water_in / inflow.integral(0, 60) - 1));
    EXPECT_NEAR(ledger.water_in / inflow.integral(0, 60), 1, 1e-6);
    EXPECT_NEAR(ledger.water_final / inflow.integral(0, 60), 1, 1e-6);
    EXPECT_EQ(ledger.water_out, 0);
}

// The built-in hydrograph brings what it says too: rise, peak and fall.
TEST(Drives, TheBuiltInInflowBringsItsIntegral) {
    const gpu::Context context;
    const Grid grid{90, 66, 5, 4};
    Simulation simulation(
        bedrock_terrain(grid, generate_heights(grid, {"hills", 3, 4})),
        parameters_with({"time.tick_s=3", "water.boundary.north=wall", "water.boundary.south=inflow",
                         "water.boundary.west=wall", "water.boundary.east=inflow", "water.inflow=300",
                         "water.inflow_rise=20", "water.inflow_fall=30"}));
    simulation.apply(Ticks{18});
    EXPECT_NEAR(simulation.ledger().water_in / (300 * 25.0), 1, 1e-6);
}

// Other numbers have their table's mean over the tick, and what rests under the old value wakes.
TEST(Drives, SlopesSlideWhenTheirAngleFalls) {
    const gpu::Context context;
    const Grid grid{64, 64, 10, 10};
    std::vector<float> heights(grid.count());
    for (std::size_t i = 0; i < heights.size(); ++i)
        heights[i] = 4.0F * static_cast<float>(std::abs(static_cast<int>(i % 64) - 32));
    Simulation simulation(bedrock_terrain(grid, heights),
                          parameters_with({"time.tick_s=1", "thermal.repose_deg=40"}));
    simulation.apply(DriveParameter{"thermal.repose_deg", TimeSeries({{0, 40}, {10, 40}, {11, 10}})});
    simulation.apply(Ticks{10});
    EXPECT_EQ(simulation.read().ground(), heights) << "4 in 10 stands at 40°";
    simulation.apply(Ticks{1});
    EXPECT_EQ(simulation.parameters().number("thermal.repose_deg"), 25);
    EXPECT_EQ(simulation.read().ground(), heights) << "and at 25°";
    simulation.apply(Ticks{3});
    EXPECT_EQ(simulation.parameters().number("thermal.repose_deg"), 10);
    EXPECT_NE(simulation.read().ground(), heights);
}

const Grid coast_grid{150, 97, 20, 25};

TerrainState coast() {
    return bedrock_terrain(coast_grid, generate_heights(coast_grid, {"coast", 5, 120}));
}

Parameters coast_parameters() {
    return parameters_with({"time.tick_s=2", "water.boundary.west=wave", "water.boundary.east=inflow",
                            "water.boundary.south=level", "water.wave=series", "water.evaporation=30",
                            "water.inflow=300"});
}

// One of several tables, or none, or a value set by hand, by a number.
void drive_something(Simulation& simulation, unsigned which) {
    const double now_s = simulation.clock().simulated_s;
    switch (which % 7) {
        case 0:
            return simulation.apply(DriveParameter{"water.rain", ragged(which, now_s + 30, 500)});
        case 1:
            return simulation.apply(DriveParameter{"water.inflow", ragged(which, now_s + 30, 800)});
        case 2:
            return simulation.apply(DriveParameter{
                "water.sea_level", TimeSeries({{now_s, 40}, {now_s + 9.3, 46}, {now_s + 20, 43}})});
        case 3:
            return simulation.apply(DriveParameter{
                "water.wave_height",
                TimeSeries({{now_s, 0}, {now_s + 3, 1.2}, {now_s + 5, -0.8}, {now_s + 9, 0}})});
        case 4:
            return simulation.apply(
                DriveParameter{"water.manning", TimeSeries({{now_s, 0.02}, {now_s + 9, 0.1}})});
        case 5:
            return simulation.apply(DriveParameter{"water.rain", {}});
        default:
            return simulation.apply(SetParameter{"water.inflow", 100.0 + which});
    }
}

TEST_P(EitherOrderOfDrives, UndoAndRedoLeadBackAndForth) {
    const gpu::Context context;
    Parameters all = coast_parameters();
    all.set("water.order", GetParam());
    Simulation simulation(coast(), all, undo_bytes);
    expect_undo_leads_back_and_forth(
        simulation, 14,
        [&](int entry) {
            if (entry % 2 == 0) return drive_something(simulation, static_cast<unsigned>(entry) / 2);
            simulation.apply(Ticks{2});
            simulation.end_entry();
        },
        [](const LedgerReading& a, const LedgerReading& b) {
            EXPECT_EQ(a.water_in, b.water_in);
            EXPECT_EQ(a.water_out, b.water_out);
            EXPECT_EQ(a.water_final, b.water_final);
        });
}

// Undo brings back the tables and what their parameters stood at.
TEST(Drives, UndoBringsBackParameters) {
    const gpu::Context context;
    Simulation simulation(coast(), coast_parameters(), undo_bytes);
    const Parameters before = simulation.parameters();
    simulation.apply(DriveParameter{"water.rain", TimeSeries({{0, 100}, {10, 200}})});
    const Parameters driven = simulation.parameters();
    EXPECT_EQ(driven.number("water.rain"), 100);
    simulation.apply(Ticks{3});
    EXPECT_EQ(simulation.parameters().number("water.rain"), 150) << "the mean of the third tick";
    simulation.end_entry();
    simulation.apply(SetParameter{"water.rain", 7.0});
    EXPECT_TRUE(simulation.drives().empty()) << "who sets it by hand takes over";
    simulation.undo();
    EXPECT_EQ(simulation.drives().size(), 1U);
    simulation.undo();
    EXPECT_EQ(simulation.parameters(), driven);
    simulation.undo();
    EXPECT_EQ(simulation.parameters(), before);
    EXPECT_TRUE(simulation.drives().empty());
}

TEST_P(EitherOrderOfDrives, FrameRateReplayAndSavingMidwayChangeNoBit) {
    const gpu::Context context;
    Parameters all = coast_parameters();
    all.set("water.order", GetParam());
    const auto play = [](Simulation& simulation, int first, int last, int substeps) {
        for (int tick = first; tick < last; ++tick) {
            if (tick % 2 == 0) drive_something(simulation, static_cast<unsigned>(tick) / 2);
            while (!simulation.advance(substeps)) {
            }
        }
    };
    Simulation whole(coast(), all);
    play(whole, 0, 20, 1 << 20);
    Simulation in_parts(coast(), all, undo_bytes);
    play(in_parts, 0, 20, 1);
    EXPECT_EQ(hash_of(whole), hash_of(in_parts));

    Simulation first(coast(), all);
    play(first, 0, 9, 2);
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / fmt::format("talus_drives_{}.exr", ::getpid());
    io::Document document;
    document.state = first.read();
    document.parameters = to_toml(first.parameters());
    io::save_document(file, document);
    // As a person opens it again.
    app::SceneRequest request;
    request.input = file.string();
    const app::Scene again = app::make_scene(request);
    request.assignments = {"water.rain=3"};
    const app::Scene by_hand = app::make_scene(request);
    std::filesystem::remove(file);
    EXPECT_EQ(again.document.state.drives, first.drives());
    EXPECT_EQ(by_hand.document.state.drives.size() + 1, first.drives().size())
        << "what is assigned follows its table no more";
    Simulation second(again.document.state, again.simulation);
    EXPECT_EQ(hash_of(second), hash_of(first));
    play(second, 9, 20, 2);
    EXPECT_EQ(hash_of(whole), hash_of(second));

    Simulation replayed(coast(), all);
    for (const Operation& operation :
         read_journal(write_journal({"", "", "{}", 0}, whole.journal()), "journal").operations)
        replayed.apply(operation);
    EXPECT_EQ(hash_of(whole), hash_of(replayed));
}

// Some ticks of 5 s from 50 s on, and with rest skipped the same.
void expect_skipping_changes_no_bit(const TerrainState& start, WaterSettings settings, int ticks) {
    settings.driven.since_s = 50;
    std::vector<std::vector<glm::vec4>> waters;
    std::vector<std::uint64_t> tiles;
    for (const bool skips : {true, false}) {
        settings.skips_rest = skips;
        Terrain terrain(start);
        terrain.add(&Terrain::water);
        Water water(terrain);
        for (int tick = 0; tick < ticks; ++tick) {
            const double from_s = 50 + 5.0 * tick;
            settings.rain_m_per_s = settings.driven.rain_mm_per_h.mean(from_s, from_s + 5) * 1e-3 / 3600;
            water.begin_tick(terrain, settings, {}, 5, 5.0 * tick);
            while (water.time_left_s() > 0) water.substep(terrain);
        }
        waters.push_back(terrain.read().water);
        tiles.push_back(water.work().tiles);
    }
    EXPECT_EQ(waters[0], waters[1]);
    EXPECT_LT(tiles[0], tiles[1]) << "something must have rested";
    double deep = 0;
    double before = 0;
    for (const glm::vec4& sample : waters[0]) deep += sample.x;
    for (const glm::vec4& sample : start.water) before += sample.x;
    EXPECT_GT(deep, before + 10) << "water must have come";
}

// A sea at rest behind edges that begin to move within a tick; inland it stays dry.
TEST_P(EitherOrderOfDrives, SkippingWhatRestsBehindEdgesChangesNoBit) {
    const gpu::Context context;
    const Grid grid{460, 400, 5, 5};
    TerrainState start = bedrock_terrain(grid, generate_heights(grid, {"coast", 5, 60}));
    fill_sea(start, 8);
    WaterSettings settings;
    settings.order = GetParam();
    settings.has_sea = true;
    settings.level_m = 8;
    settings.wave_form = WaveForm::series;
    settings.driven.sea_level_m = TimeSeries({{50, 8}, {52.5, 8}, {58, 9.5}, {70, 9.5}});
    settings.driven.wave_height_m = TimeSeries({{50, 0}, {56.4, 0}, {57, 0.5}, {58, -0.4}, {59, 0}});
    for (const EdgeKind kind : {EdgeKind::level, EdgeKind::wave}) {
        settings.edges.fill(kind);
        expect_skipping_changes_no_bit(start, settings, 3);
    }
}

// Rain by the mask that begins within a tick, after one in which none falls.
TEST_P(EitherOrderOfDrives, SkippingWhereItDoesNotRainYetChangesNoBit) {
    const gpu::Context context;
    const Grid grid{300, 200, 5, 5};
    TerrainState start = bedrock_terrain(grid, generate_heights(grid, {"hills", 5, 40}));
    start.painted.assign(grid.count(), glm::vec4(0));
    for (std::size_t i = 0; i < grid.count(); ++i) start.painted[i].y = i % 300 > 120 ? 0.7F : 0.0F;
    WaterSettings settings;
    settings.order = GetParam();
    settings.rain_masked = true;
    settings.driven.rain_mm_per_h = TimeSeries({{50, 0}, {58.7, 0}, {59, 3000}, {62, 0}});
    expect_skipping_changes_no_bit(start, settings, 4);
}

// So little that the water rests all the same: undo takes it back.
TEST_P(EitherOrderOfDrives, UndoTakesBackATrickleOverAnEdge) {
    const gpu::Context context;
    const Grid grid{100, 80, 10, 10};
    TerrainState lake = bedrock_terrain(grid, std::vector<float>(grid.count(), 0.0F));
    lake.water.assign(grid.count(), glm::vec4(1, 0, 0, 0));
    Parameters all =
        parameters_with({"time.tick_s=1", "water.boundary.north=wall", "water.boundary.south=wall",
                         "water.boundary.east=wall", "water.boundary.west=inflow", "water.inflow=0.0001"});
    all.set("water.order", GetParam());
    Simulation simulation(lake, all, undo_bytes);
    const std::uint64_t before = hash_of(simulation);
    simulation.apply(Ticks{5});
    simulation.end_entry();
    EXPECT_NEAR(simulation.ledger().water_in, 0.0005, 1e-9);
    EXPECT_NEAR(simulation.ledger().water_drift_relative(), 0, 1e-12);
    EXPECT_NE(hash_of(simulation), before);
    simulation.undo();
    EXPECT_EQ(hash_of(simulation), before);
}

// A point of one of a tick's tables.
float table_at(const std::vector<float>& series, int table, int point) {
    return series[static_cast<std::size_t>(table) * glsl::tick_series_points +
                  static_cast<std::size_t>(point)];
}

// An even inflow and rain are the same in each step of a tick.
TEST(Drives, WhatIsEvenStaysEven) {
    const Grid grid{64, 64, 1, 1};
    WaterSettings settings;
    settings.edges = {EdgeKind::wall, EdgeKind::wall, EdgeKind::inflow, EdgeKind::wall};
    settings.inflow_m3_per_s = 6.4;
    settings.rain_m_per_s = 1e-5;
    const std::vector<float> series = tick_series(settings, grid, 100, 7);
    for (int i = 0; i < glsl::tick_series_steps; ++i) {
        EXPECT_EQ(table_at(series, glsl::series_inflow, i), 0.1F);
        EXPECT_EQ(table_at(series, glsl::series_rain, i), 1e-5F);
    }
}

using maths::max;
using maths::min;

// The tables as the water's twin in float reads them.
struct ReadTables {
    TALUS_TWIN_NAMES(float)
    std::vector<float> tables;
    real load_tick_series(int at) const { return tables[static_cast<std::size_t>(at)]; }
#include "maths/tick_series_values.glsl"
#include "maths/two_sum.glsl"
};

TEST(Drives, MeansOverSubStepsAreEvenOrSumUp) {
    ReadTables read;
    read.tables.assign(glsl::tick_series_tables * glsl::tick_series_points, 0.3F);
    std::mt19937 random(8);
    std::uniform_real_distribution<float> unit(0, 1);
    for (int i = 0; i < 2000; ++i) {
        const float a = unit(random);
        const float b = unit(random) < 0.5F ? a + 1e-6F : unit(random);
        EXPECT_EQ(read.tick_series_mean(glsl::series_rain, std::min(a, b), std::max(a, b)), 0.3F);
    }
    double whole = 0;
    for (int step = 0; step < glsl::tick_series_steps; ++step) {
        const float value = unit(random) < 0.3F ? 0 : unit(random);
        read.tables[static_cast<std::size_t>(glsl::series_rain) * glsl::tick_series_points +
                    static_cast<std::size_t>(step)] = value;
        whole += static_cast<double>(value) / glsl::tick_series_steps;
    }
    for (const int parts : {1, 3, 77, 256, 5000}) {
        double sum = 0;
        for (int i = 0; i < parts; ++i) {
            const auto from = static_cast<float>(static_cast<double>(i) / parts);
            const auto to = static_cast<float>(static_cast<double>(i + 1) / parts);
            sum += static_cast<double>(read.tick_series_mean(glsl::series_rain, from, to)) *
                   (static_cast<double>(to) - from);
        }
        EXPECT_NEAR(sum / whole, 1, 2e-7) << parts;
    }
}

// The level moves within a tick, linear between the table's rows.
TEST(Drives, LevelAndWaveAreTabulatedWithinTheTick) {
    WaterSettings settings;
    settings.wave_form = WaveForm::series;
    settings.driven.since_s = 30;
    settings.driven.sea_level_m = TimeSeries({{40, 5}, {42, 9}});
    settings.driven.wave_height_m = TimeSeries({{40, -1}, {44, 1}});
    const std::vector<float> series = tick_series(settings, {64, 64, 1, 1}, 4, 10);
    const auto at = [&](int table, int point) { return table_at(series, table, point); };
    EXPECT_FLOAT_EQ(at(glsl::series_level, 0), 5);
    EXPECT_FLOAT_EQ(at(glsl::series_level, 64), 7);
    EXPECT_FLOAT_EQ(at(glsl::series_level, 256), 9);
    EXPECT_FLOAT_EQ(at(glsl::series_wave, 128), 0);
    EXPECT_FLOAT_EQ(at(glsl::series_wave, 256), 1);
    // Without a table nothing comes.
    settings.driven.wave_height_m = {};
    EXPECT_EQ(table_at(tick_series(settings, {64, 64, 1, 1}, 4, 10), glsl::series_wave, 7), 0);
}

// What a pass reads within the tick is what is declared so.
TEST(Drives, TablesWithinTheTickAreTheWaters) {
    std::vector<std::string> declared;
    for (const Parameter& p : simulation_parameters())
        if (p.driven == Driven::within_tick) declared.push_back(p.name);
    std::vector<std::string> read;
    for (const WaterDrive& one : water_drives()) read.emplace_back(one.parameter);
    std::sort(declared.begin(), declared.end());
    std::sort(read.begin(), read.end());
    EXPECT_EQ(declared, read);
}

// A table that asks for too much later is refused with the tick that it would not fit into.
TEST(Drives, ATickMustFitAllThatATableSays) {
    const gpu::Context context;
    Simulation simulation(coast(), coast_parameters(), undo_bytes);
    simulation.apply(DriveParameter{"thermal.rate_m2_per_s", TimeSeries({{0, 1}, {1000, 40}})});
    const Parameters before = simulation.parameters();
    EXPECT_THROW(simulation.apply(SetParameter{"time.tick_s", 1e6}), Error);
    EXPECT_EQ(simulation.parameters(), before);
    simulation.apply(DriveParameter{"thermal.rate_m2_per_s", {}});
    EXPECT_NO_THROW(simulation.apply(SetParameter{"time.tick_s", 2.5}));
}

// The right table takes the place of a wrong one, and its sea of that one's.
TEST(Drives, AnotherTableOfTheSeaTakesThePlaceOfTheFirst) {
    const gpu::Context context;
    const TimeSeries high({{0, 60}});
    const TimeSeries low({{0, 20}});
    Simulation straight(coast(), coast_parameters());
    straight.apply(DriveParameter{"water.sea_level", low});
    Simulation corrected(coast(), coast_parameters(), undo_bytes);
    corrected.apply(DriveParameter{"water.sea_level", high});
    corrected.apply(DriveParameter{"water.sea_level", low});
    EXPECT_EQ(hash_of(corrected), hash_of(straight));
    corrected.undo();
    EXPECT_FALSE(corrected.can_undo());
    corrected.apply(SetParameter{"water.sea_level", 50.0});
    corrected.apply(DriveParameter{"water.sea_level", low});
    EXPECT_EQ(hash_of(corrected), hash_of(straight));
}

TEST(Drives, TextOfATableIsReadOrRefused) {
    const TimeSeries series = ragged(3, 5, 1e-7);
    EXPECT_EQ(series_from_text(to_text(series)), series);
    for (const char* wrong :
         {"", "0", "0 1 5", "0 1 x 2", "0 1e999", "5 1 4 1", "0 1 -", "0 1 5e", "0 1 2 3,"})
        EXPECT_THROW(series_from_text(wrong), Error) << wrong;
}

TEST(Drives, RefuseWhatCannotFollowATable) {
    const gpu::Context context;
    Simulation simulation(coast(), coast_parameters(), undo_bytes);
    const Parameters before = simulation.parameters();
    const TimeSeries one({{0, 1}});
    for (const Drive& wrong : {Drive{"water.nothing", one}, Drive{"water.on", one}, Drive{"water.order", one},
                               Drive{"terrain.relief_m", one}, Drive{"time.tick_s", one},
                               Drive{"erosion.porosity", TimeSeries({{0, 0.3}})},
                               Drive{"water.rain", TimeSeries({{0, 3}, {5, -1}})},
                               Drive{"water.rain", TimeSeries({{0, 3}, {5, 1e9}})},
                               // A tick of it would take too many sub-steps.
                               Drive{"thermal.rate_m2_per_s", TimeSeries({{0, 1}, {100, 1e9}})}})
        EXPECT_THROW(simulation.apply(DriveParameter{wrong}), Error) << wrong.parameter;
    EXPECT_TRUE(simulation.drives().empty());
    EXPECT_EQ(simulation.parameters(), before);
    EXPECT_FALSE(simulation.can_undo());
}

std::string refusal_of(const std::string& text) {
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / fmt::format("talus_table_{}.csv", ::getpid());
    std::FILE* out = std::fopen(file.c_str(), "wb");
    fmt::print(out, "{}", text);
    std::fclose(out);
    std::string said;
    try {
        const TimeSeries read = io::read_time_series(file);
        for (const TimeSeries::Row& row : read.rows()) said += fmt::format("{}:{} ", row.time_s, row.value);
    } catch (const Error& error) {
        said = error.what();
        const auto name = said.find(file.string());
        EXPECT_NE(name, std::string::npos) << said;
        if (name != std::string::npos) said.replace(name, file.string().size(), "FILE");
    }
    std::filesystem::remove(file);
    return said;
}

TEST(TimeSeriesFiles, AreReadAsSpreadsheetsWriteThem) {
    EXPECT_EQ(refusal_of("time_s,value\n0,1\n600,2.5\n"), "0:1 600:2.5 ");
    EXPECT_EQ(refusal_of("\xEF\xBB\xBFTime (s);Rain (mm/h)\r\n0;1\r\n\r\n 600 ; 2.5 \r\n"), "0:1 600:2.5 ");
    EXPECT_EQ(refusal_of("# of a gauge\n0\t1\n600 2.5"), "0:1 600:2.5 ");
    EXPECT_EQ(refusal_of("\"0\",\"+1e1\"\n"), "0:10 ");
    EXPECT_EQ(refusal_of("0,1\n5,1\n5,3\n"), "0:1 5:1 5:3 ");
}

TEST(TimeSeriesFiles, SayWhichLineIsWrong) {
    const std::string row = "it must be a time in seconds and a value, e.g. 600,12.5";
    EXPECT_EQ(refusal_of("0,1\n600\n"), "'FILE': line 2 is '600', " + row);
    EXPECT_EQ(refusal_of("0,1\n600,2,3\n"), "'FILE': line 2 is '600,2,3', " + row);
    EXPECT_EQ(refusal_of("0,1\n600,\n"), "'FILE': line 2 is '600,', " + row);
    EXPECT_EQ(refusal_of("0,1\n,600\n"), "'FILE': line 2 is ',600', " + row);
    EXPECT_EQ(refusal_of("time,value\n0,1\nlater,3\n"), "'FILE': line 3 is 'later,3', " + row);
    EXPECT_EQ(refusal_of("0,nan\n"), "'FILE': line 1 is '0,nan', " + row);
    EXPECT_EQ(refusal_of("0,1e999\n"), "'FILE': line 1 is '0,1e999', " + row);
    EXPECT_EQ(refusal_of("0;1,5\n"), "'FILE': line 1 is '0;1,5', " + row);
    EXPECT_EQ(refusal_of("0,+-5\n"), "'FILE': line 1 is '0,+-5', " + row);
    EXPECT_EQ(refusal_of("0,1\n" + std::string(1000, 'x') + "\n"),
              "'FILE': line 2 is '" + std::string(60, 'x') + "…', " + row);
    EXPECT_EQ(refusal_of("5,1\n4,1\n"), "'FILE': line 2 is of 4 s and comes after 5 s, times must not fall");
    EXPECT_EQ(refusal_of("time,value\n"), "'FILE' holds no row of a time in seconds and a value");
    EXPECT_EQ(refusal_of(std::string("0,1\0", 4)),
              "'FILE' is no text, a table of times and values is needed");
    EXPECT_EQ(refusal_of(""), "'FILE' holds no row of a time in seconds and a value");
    EXPECT_THROW(io::read_time_series("/nowhere.csv"), Error);
    EXPECT_THROW(io::read_time_series("/"), Error);
}

}  // namespace
}  // namespace talus::drives_test

#include "app/claims/histories.h"

#include <unistd.h>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>

#include "app/claims/differing_bits.h"
#include "app/claims/water_scenes.h"
#include "sim/io/document.h"
#include "sim/preset.h"
#include "sim/simulation.h"
#include "sim/simulation_parameters.h"
#include "sim/terrain/bed_beyond.h"
#include "sim/terrain/generate.h"
#include "sim/terrain/state_hash.h"

namespace talus::claims {
namespace {

namespace fs = std::filesystem;

const Grid worked_grid{150, 110, 20, 25};

TerrainState mountains() {
    return bedrock_terrain(worked_grid, generate_heights(worked_grid, {"mountains", 5, 900}));
}

Parameters rainy() {
    Parameters parameters((simulation_parameters()));
    for (const char* assignment : {"water.rain_mm_per_h=300", "erosion.on=true", "time.tick_s=0.5",
                                   "erosion.acceleration=20", "erosion.porosity=0.3"})
        parameters.set_assignment(assignment);
    return parameters;
}

Dab some_dab(std::mt19937& random) {
    std::uniform_real_distribution<double> unit(0, 1);
    Dab dab;
    dab.effect = effect_of(static_cast<BrushMode>(random() % 7));
    if (auto* ramp = dab.as<RampDab>()) ramp->way_m = {400 * unit(random), 300 * unit(random)};
    dab.material = static_cast<Material>(random() % 4);
    dab.x_m = worked_grid.width_m() * unit(random);
    dab.y_m = worked_grid.height_m() * unit(random);
    dab.radius_m = 60 + 400 * unit(random);
    dab.falloff = unit(random);
    dab.amount_m = 10 * unit(random);
    dab.blend = unit(random);
    dab.target_m = unit(random);
    return dab;
}

// One entry of undo.
void act(Simulation& simulation, int number, std::mt19937& random) {
    if (number % 3 == 0) {
        simulation.begin_stroke("stroke");
        for (int i = 0; i < 3; ++i) simulation.apply(some_dab(random));
        simulation.end_entry();
    } else if (number % 3 == 1) {
        simulation.apply(Ticks{4});
        simulation.end_entry();
    } else {
        simulation.apply(SetParameter{"thermal.repose_deg", 25.0 + number});
    }
}

std::uint64_t hash_of(const Simulation& simulation) {
    return state_hash(simulation.read());
}

// Its state through a file: as a session that is saved and opened again.
Simulation reopened(const Simulation& simulation) {
    const fs::path path = fs::temp_directory_path() / ("talus_verify_" + std::to_string(::getpid()) + ".exr");
    io::Document document;
    document.state = simulation.read();
    document.parameters = to_toml(simulation.parameters());
    io::save_document(path, document);
    const io::Document read = io::open_document(path, {});
    std::error_code ignored;
    fs::remove(path, ignored);
    Parameters parameters((simulation_parameters()));
    from_toml(read.parameters, path.string(), parameters);
    return {read.state, parameters};
}

}  // namespace

HistoryFaults history_faults() {
    constexpr int acts = 9;
    HistoryFaults faults;
    Simulation simulation(mountains(), rainy(), std::size_t{256} << 20U);
    std::mt19937 random(7);
    std::vector<std::uint64_t> hashes = {hash_of(simulation)};
    for (int i = 0; i < acts; ++i) {
        act(simulation, i, random);
        hashes.push_back(hash_of(simulation));
    }
    faults.states = acts + 1;
    for (int i = acts - 1; i >= 0; --i) {
        simulation.undo();
        faults.undo += hash_of(simulation) == hashes[static_cast<std::size_t>(i)] ? 0 : 1;
    }
    for (int i = 1; i <= acts; ++i) {
        simulation.redo();
        faults.redo += hash_of(simulation) == hashes[static_cast<std::size_t>(i)] ? 0 : 1;
    }
    Simulation replayed(mountains(), rainy());
    for (const Operation& operation :
         read_journal(write_journal({}, simulation.journal()), "journal").operations)
        replayed.apply(operation);
    faults.replay = hash_of(replayed) != hashes.back();
    Simulation continued = reopened(simulation);
    continued.apply(Ticks{6});
    simulation.apply(Ticks{6});
    faults.reload = hash_of(continued) != hash_of(simulation);
    return faults;
}

SkippedRest skipped_rest(int order, bool driven, double seconds) {
    // Water that comes down into a corner of a dry map, and leaves its film behind.
    scenes::WaterScene scene = scenes::basin(320, 5);
    scene.settings.order = order;
    scene.settings.manning_s_per_m13 = 0.02;
    scene.water = [bed = scene.bed](double x, double y, double) {
        return glm::dvec3(x < 300 && y < 300 ? std::max(0.0, 6 - bed(x, y)) : 0, 0, 0);
    };
    // What wakes tiles besides: two springs, waves and a level at edges, ground that falls beyond one, and
    // losses.
    if (driven) {
        scene.knows_bed_beyond = true;
        scene.settings.edges = {EdgeKind::wall, EdgeKind::open, EdgeKind::level, EdgeKind::wave};
        scene.settings.level_m = -1;
        scene.settings.wave_height_m = 0.5;
        scene.settings.wave_period_s = 20;
        scene.settings.evaporation_m_per_s = 2e-6;
    }
    TerrainState start = scene.state();
    // It is known in stretches.
    for (std::size_t i = 0; i < start.bed_beyond.size(); ++i)
        if (i / 80 % 2 == 0) start.bed_beyond[i] = glsl::unknown_bed;
    if (driven) {  // and rain that was painted over a square of 20 samples
        scene.settings.rain_painted = true;
        start.painted.assign(start.grid.count(), glm::vec4(0));
        for (int row = 100; row < 120; ++row)
            for (int column = 200; column < 220; ++column)
                start.painted[static_cast<std::size_t>(row) * 320 + column].z = 90;
    }
    scenes::WaterRun sparse(start, scene.settings);
    scenes::WaterRun dense(start, scene.settings);
    dense.settings.skips_rest = false;
    if (driven) sparse.springs = dense.springs = {{800, 800, 3}, {1300, 700, 1e-6}};
    SkippedRest rest;
    for (int i = 0; i < 2; ++i) {
        sparse.run(1, sparse.time_s() + seconds / 2);
        dense.run(1, dense.time_s() + seconds / 2);
        rest.differing += differing_bits(sparse.read().water, dense.read().water);
    }
    rest.active_tiles = sparse.water.work().tiles;
    rest.all_tiles = dense.water.work().tiles;
    return rest;
}

LedgerErrors ledger_errors() {
    Simulation simulation(mountains(), rainy());
    std::mt19937 random(11);
    simulation.apply(PlaceSpring{1500, 1200, 4});
    for (int i = 0; i < 12; ++i) {
        simulation.apply(some_dab(random));
        simulation.apply(Ticks{8});
    }
    const LedgerReading ledger = simulation.ledger();
    return {std::abs(ledger.closing_error_of_moved()), std::abs(ledger.water_drift_relative())};
}

double table_error() {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(0, 1);
    const auto table = [&](double highest) {
        std::vector<TimeSeries::Row> rows = {{0, 0}};
        while (rows.back().time_s < 25) {
            const double after_s = 0.05 * unit(random) * unit(random);
            rows.push_back({rows.back().time_s + after_s, highest * unit(random)});
        }
        return TimeSeries(std::move(rows));
    };
    const TimeSeries rain = table(900);
    const TimeSeries inflow = table(4000);
    Parameters parameters((simulation_parameters()));
    for (const char* assignment :
         {"time.tick_s=2", "water.boundary.north=wall", "water.boundary.south=inflow",
          "water.boundary.west=wall", "water.boundary.east=wall"})
        parameters.set_assignment(assignment);
    Simulation simulation(mountains(), parameters);
    simulation.apply(DriveParameter{"water.rain_mm_per_h", rain});
    simulation.apply(DriveParameter{"water.inflow_m3_per_s", inflow});
    simulation.apply(Ticks{10});
    const double area_m2 = worked_grid.dx * worked_grid.dy * static_cast<double>(worked_grid.count());
    const double wanted = rain.integral(0, 20) * 1e-3 / 3600 * area_m2 + inflow.integral(0, 20);
    return std::abs(simulation.ledger().water_in / wanted - 1);
}

}  // namespace talus::claims

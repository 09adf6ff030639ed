#include "app/core/report.h"

#include "app/core/wall_clock.h"
#include "sim/terrain/gauge.h"
#include "sim/terrain/state_hash.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace talus::app {
namespace {

const double loaded_at_s = wall_clock_s();

}  // namespace

std::string run_report(const RunFigures& figures, const TerrainState& state, Simulation& simulation) {
    const LedgerReading ledger = simulation.ledger();
    const std::vector<float> ground = state.ground();
    const auto [low, high] = std::minmax_element(ground.begin(), ground.end());
    nlohmann::ordered_json report;
    report["device"] = gpu::describe(figures.device);
    report["nx"] = state.grid.nx;
    report["ny"] = state.grid.ny;
    report["dx"] = state.grid.dx;
    report["dy"] = state.grid.dy;
    report["ticks"] = figures.ticks;
    report["simulated_s"] = state.clock.simulated_s;
    report["wall_s"] = figures.wall_s;
    report["cpu_s"] = figures.cpu_s;
    report["hash"] = fmt::format("{:016x}", state_hash(state));
    report["height_min"] = *low;
    report["height_max"] = *high;
    report["ledger"] = {{"solid_initial", ledger.solid_initial},
                        {"solid_final", ledger.solid_final},
                        {"solid_in", ledger.solid_in},
                        {"solid_out", ledger.solid_out},
                        {"moved_m3", ledger.moved_m3()},
                        {"closing_error_of_moved", ledger.closing_error_of_moved()},
                        {"bedrock_m3", ledger.bedrock},
                        {"regolith_m3", ledger.regolith},
                        {"eroded_m3", ledger.eroded_m3},
                        {"deposited_m3", ledger.deposited_m3},
                        {"suspended_m3", ledger.suspended},
                        {"out_m3", ledger.solid_edges_out},
                        {"closing_error_of_eroded", ledger.closing_error_of_eroded()}};
    if (!state.water.empty()) {
        double fastest = 0;
        float lowest = state.water[0].x;
        for (const glm::vec4& water : state.water) {
            fastest = std::max(fastest, glm::length(water_velocity(water.x, {water.z, water.w})));
            lowest = std::min(lowest, water.x);
        }
        const PassWork work = simulation.work("water");
        report["water"] = {
            {"initial_m3", ledger.water_initial},
            {"final_m3", ledger.water_final},
            {"in_m3", ledger.water_in},
            {"out_m3", ledger.water_out},
            {"drift_relative", ledger.water_drift_relative()},
            {"max_speed", fastest},
            {"min_depth", lowest},
            {"substeps", work.substeps},
            {"active_tiles_mean", static_cast<double>(work.tiles) /
                                      static_cast<double>(std::max<std::uint64_t>(work.substeps, 1))}};
    }
    return report.dump(2) + "\n";
}

void say(const std::string& message) {
    fmt::print(stderr, "{}\n", message);
}

double seconds_since_start() {
    return wall_clock_s() - loaded_at_s;
}

double process_cpu_s() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

}  // namespace talus::app

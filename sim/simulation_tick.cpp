// How a tick of the simulation begins, by tables and events, and goes on.
#include <fmt/format.h>

#include <numeric>
#include <utility>

#include "sim/drives.h"
#include "sim/error.h"
#include "sim/events.h"
#include "sim/simulation.h"

namespace talus {

void Simulation::follow_tables() {
    const double from_s = moment_.clock.simulated_s;
    const double to_s = from_s + moment_.parameters.number("time.tick_s");
    bool wakes = false;
    for (const Drive& drive : moment_.drives) {
        const double value = drive.series.mean(from_s, to_s);
        if (moment_.parameters.number(drive.parameter) == value) continue;
        moment_.parameters.set(drive.parameter, value);
        wakes = wakes || moment_.parameters.declaration(drive.parameter).driven != Driven::within_tick;
    }
    // Rest was decided under the old values. A pass that reads tables within the tick wakes what they move.
    if (wakes) terrain_.tiles.mark_all();
}

// A time that whole ticks add up to may miss the event's by roundings.
constexpr double event_rounding = 1e-9;

void Simulation::fit_events(const Grid& grid, const Parameters& parameters, const std::vector<Drive>& drives,
                            const std::vector<Event>& events) const {
    Parameters then = parameters;
    for (const Event& event : events) {
        if (event.done || event.breach) continue;
        then.set_assignment(event.assignment);
        try {
            Parameters fitted = then;
            fit(grid, fitted, drives);
        } catch (const Error& error) {
            throw Error(fmt::format("the event at {}: {}", name_of(event), error.what()));
        }
    }
}

void Simulation::set_by_events() {
    const double now_s = moment_.clock.simulated_s;
    for (Event& event : moment_.events) {
        if (event.done || event.breach || event.at_s > now_s * (1 + event_rounding)) continue;
        const std::string name = parameter_of(event);
        Parameters changed = moment_.parameters;
        changed.set_assignment(event.assignment);
        std::vector<Drive> drives = moment_.drives;
        place_drive(drives, {name, {}});
        try {
            fit(terrain_.grid(), changed, drives);
        } catch (const Error& error) {
            throw Error(fmt::format("the event at {}: {}", name_of(event), error.what()));
        }
        const SetsOff sets_off = changed.declaration(name).sets_off;
        if (sets_off == SetsOff::solid_weights) reweigh(changed);
        if (sets_off == SetsOff::edge_clock) moment_.edges_since_s = now_s;
        moment_.parameters = std::move(changed);
        moment_.drives = std::move(drives);
        event.done = true;
        // Rest was decided under the old values.
        terrain_.tiles.mark_all();
    }
}

void Simulation::breach_by_events() {
    const double now_s = moment_.clock.simulated_s * (1 + event_rounding);
    for (Event& event : moment_.events) {
        if (event.done || !event.breach || event.at_s > now_s) continue;
        const double share = share_at(event, now_s);
        if (share > 0) act_by_pass(dab_of(*event.breach, share));
        event.done = share >= 1;
    }
}

void Simulation::begin_tick() {
    std::optional<Moment> before;
    if ((keeps_undo_ && !undo_.is_open()) || !moment_.drives.empty() || !moment_.events.empty())
        before = moment_;
    try {
        follow_tables();
        set_by_events();
        for (const auto& pass : passes_) pass->prepare_tick(terrain_, moment_);
    } catch (...) {
        if (before) moment_ = std::move(*before);
        throw;
    }
    if (keeps_undo_) {
        if (!undo_.is_open()) {
            Snapshot at_start = snapshot();
            at_start.moment = std::move(*before);
            undo_.open(name_of(Ticks()), terrain_, journal_, std::move(at_start));
        }
        undo_.keep_all(terrain_);
    }
    breach_by_events();
    pass_ = 0;
    in_tick_ = true;
}

bool Simulation::advance(int substeps) {
    if (!in_tick_) begin_tick();
    for (; pass_ < passes_.size(); ++pass_)
        if (!passes_[pass_]->advance(terrain_, moment_, substeps)) return false;
    in_tick_ = false;
    moment_.clock.ticks += 1;
    moment_.clock.simulated_s += moment_.parameters.number("time.tick_s");
    journal_.record(Ticks{1});
    return true;
}

std::uint64_t Simulation::substeps_sent() const {
    return std::accumulate(passes_.begin(), passes_.end(), std::uint64_t{0},
                           [](std::uint64_t sum, const auto& pass) { return sum + pass->substeps_sent(); });
}

}  // namespace talus

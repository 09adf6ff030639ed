#include "sim/simulation.h"

#include "sim/gpu/error.h"

namespace talus {
namespace {

ThermalSettings thermal_settings(const Parameters& parameters) {
    return {parameters.number("thermal.repose_deg"), parameters.number("thermal.rate_m2_per_s")};
}

}  // namespace

Simulation::Simulation(const TerrainState& state, const Parameters& parameters, std::size_t undo_bytes)
    : terrain_(state),
      brush_(terrain_),
      thermal_(terrain_),
      ledger_(terrain_),
      moment_{state.clock, parameters},
      undo_(undo_bytes),
      keeps_undo_(undo_bytes > 0) {
    moment_.parameters.suggest("thermal.rate_m2_per_s",
                               natural_thermal_rate(state.grid, parameters.number("time.tick_s")));
    check_tick(moment_.parameters);
}

void Simulation::apply(const Operation& operation) {
    if (const auto* ticks = std::get_if<Ticks>(&operation)) {
        for (std::int64_t i = 0; i < ticks->count; ++i)
            while (!advance(1 << 20)) {
            }
        return;
    }
    if (mid_tick()) throw Error("a tick is half done: complete it before anything else is applied");
    if (const auto* set = std::get_if<SetParameter>(&operation)) {
        Parameters changed = moment_.parameters;
        changed.set(set->name, set->value);
        check_tick(changed);
        // A slider that is dragged is one entry.
        const bool entry = keeps_undo_ && !undo_.is_open() && !undo_.extends(set->name);
        if (entry) undo_.open(set->name, terrain_, brush_, journal_, moment_);
        moment_.parameters = changed;
        journal_.record(operation);
        if (entry) undo_.close(terrain_, journal_);
        // Rest was decided under the old values.
        terrain_.tiles.mark_all();
        return;
    }
    const auto& dab = std::get<Dab>(operation);
    check_dab(dab);
    const bool entry = keeps_undo_ && !undo_.is_open();
    if (entry) undo_.open("dab", terrain_, brush_, journal_, moment_);
    if (keeps_undo_) undo_.keep(terrain_, terrain_.tiles.touched_by(dab_region(terrain_.grid(), dab)));
    brush_.dab(terrain_, dab);
    journal_.record(operation);
    if (entry) end_entry();
}

void Simulation::check_tick(const Parameters& parameters) const {
    if (parameters.toggle("thermal.on"))
        thermal_substeps(terrain_.grid(), thermal_settings(parameters), parameters.number("time.tick_s"));
}

bool Simulation::advance(int substeps) {
    const Parameters& parameters = moment_.parameters;
    const double tick_s = parameters.number("time.tick_s");
    const bool thermal = parameters.toggle("thermal.on");
    if (substeps_done_ == 0) {
        const ThermalSettings settings = thermal_settings(parameters);
        substeps_of_tick_ = thermal ? thermal_substeps(terrain_.grid(), settings, tick_s) : 0;
        if (thermal) step_ = thermal_step(terrain_.grid(), settings, tick_s, substeps_of_tick_);
        if (keeps_undo_) {
            if (!undo_.is_open()) undo_.open("run", terrain_, brush_, journal_, moment_);
            undo_.keep_all(terrain_);
        }
    }
    for (; substeps > 0 && substeps_done_ < substeps_of_tick_; --substeps, ++substeps_done_)
        thermal_.substep(terrain_, step_);
    if (substeps_done_ < substeps_of_tick_) return false;
    substeps_done_ = 0;
    moment_.clock.ticks += 1;
    moment_.clock.simulated_s += tick_s;
    journal_.record(Ticks{1});
    return true;
}

void Simulation::begin_stroke(const std::string& name) {
    if (!keeps_undo_) return;
    end_entry();
    undo_.open(name, terrain_, brush_, journal_, moment_);
}

void Simulation::end_entry() {
    undo_.close(terrain_, journal_);
}

void Simulation::exchange(void (Undo::*way)(Terrain&, Brush&, Journal&, Moment&)) {
    (undo_.*way)(terrain_, brush_, journal_, moment_);
    terrain_.tiles.mark_all();
}

void Simulation::undo() {
    while (mid_tick()) advance(1 << 20);
    end_entry();
    if (can_undo()) exchange(&Undo::undo);
}

void Simulation::redo() {
    while (mid_tick()) advance(1 << 20);
    end_entry();
    if (can_redo()) exchange(&Undo::redo);
}

LedgerReading Simulation::ledger() {
    return ledger_.read(terrain_, brush_);
}

TerrainState Simulation::read() const {
    TerrainState state = terrain_.read();
    state.clock = moment_.clock;
    return state;
}

}  // namespace talus

#include "sim/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>
#include <utility>

#include "sim/drives.h"
#include "sim/error.h"
#include "sim/events.h"
#include "sim/figure.h"
#include "sim/passes/dab_region.h"
#include "sim/passes/map_settings.h"
#include "sim/passes/passes.h"
#include "sim/terrain/layers.h"
#include "sim/terrain/sea.h"
#include "sim/terrain/springs.h"

namespace talus {

struct Simulation::Site {
    explicit Site(Terrain stands_on)
        : terrain(std::move(stands_on)),
          passes(passes_for(terrain)),
          ledger(std::make_unique<Ledger>(terrain)) {}
    Terrain terrain;
    std::vector<std::unique_ptr<Pass>> passes;
    std::unique_ptr<Ledger> ledger;
};

Simulation::Simulation(const TerrainState& state, const Parameters& parameters, std::size_t undo_bytes)
    : terrain_(state),
      passes_(passes_for(terrain_)),
      moment_{.clock = state.clock,
              .parameters = parameters,
              .springs = state.springs,
              .drives = state.drives,
              .events = state.events,
              .edges_since_s = state.edges_since_s,
              .georeference = state.georeference},
      undo_(undo_bytes),
      keeps_undo_(undo_bytes > 0) {
    for (Drive& drive : moment_.drives) {
        check_drive(moment_.parameters, drive);
        drive.parameter = moment_.parameters.declaration(drive.parameter).name;
    }
    check_events(moment_.parameters, state.grid, moment_.events);
    fit(state.grid, moment_.parameters, moment_.drives);
    fit_events(state.grid, moment_.parameters, moment_.drives, moment_.events);
    observe();
    // What was saved midway holds what is left of its sea.
    if (state.clock.ticks == 0 && moment_.parameters.is_given("water.sea_level_m")) fill_sea_now();
    moment_.sea_m3 = 0;
    ledger_ = std::make_unique<Ledger>(terrain_);
    moment_.ledger = ledger_->begin(terrain_, solid_weights(moment_.parameters));
}

std::vector<Book> Simulation::books() {
    std::vector<Book> books;
    for (const auto& pass : passes_)
        for (Book& book : pass->books()) books.push_back(std::move(book));
    return books;
}

void Simulation::fit(const Grid& grid, Parameters& parameters, const std::vector<Drive>& drives) const {
    for (const auto& pass : passes_) pass->fit(grid, parameters);
    for (const Drive& drive : drives)
        for (const double value : {drive.series.lowest(), drive.series.highest()}) {
            Parameters then = parameters;
            then.set(drive.parameter, value);
            for (const auto& pass : passes_) pass->fit(grid, then);
        }
}

void Simulation::observe() {
    for (const auto& pass : passes_) pass->observe(terrain_, moment_);
}

void Simulation::fill_sea_now() {
    TerrainState state = terrain_.read();
    moment_.sea_m3 += fill_sea(state, moment_.parameters.number("water.sea_level_m"));
    terrain_.add(&Terrain::water);
    terrain_.write(&Terrain::water, state);
    observe();
}

void Simulation::apply(const Operation& operation) {
    if (const auto* ticks = std::get_if<Ticks>(&operation)) {
        for (std::int64_t i = 0; i < ticks->count; ++i)
            while (!advance(1 << 20)) {
            }
        return;
    }
    if (mid_tick()) throw Error("a tick is half done: complete it before anything else is applied");
    std::visit(
        [this](const auto& one) {
            if constexpr (!std::is_same_v<std::decay_t<decltype(one)>, Ticks>) act(one);
        },
        operation);
}

std::string Simulation::history_name(const Operation& operation) const {
    if (const auto* set = std::get_if<SetParameter>(&operation)) {
        const Parameter& p = parameters().declaration(set->name);
        return label_of(p) + ": " + (set->value ? value_text(p, *set->value) : "as by default");
    }
    if (const auto* drive = std::get_if<DriveParameter>(&operation))
        return (drive->series.empty() ? "End of the table: " : "Table: ") +
               label_of(parameters().declaration(drive->parameter));
    return name_of(operation);
}

template <typename Change>
void Simulation::record(const Operation& operation, Change&& change) {
    const bool entry = keeps_undo_ && !undo_.is_open();
    const auto* set = std::get_if<SetParameter>(&operation);
    if (entry)
        undo_.open(history_name(operation), terrain_, journal_, snapshot(), set ? set->name : std::string());
    try {
        change();
    } catch (...) {
        if (entry) undo_.abandon();
        throw;
    }
    journal_.record(operation);
    if (entry) undo_.close(terrain_, journal_);
}

void Simulation::act(const SetParameter& wanted) {
    SetParameter set = wanted;
    set.name = moment_.parameters.declaration(wanted.name).name;
    Parameters changed = moment_.parameters;
    if (set.value)
        changed.set(set.name, *set.value);
    else
        changed.reset(set.name);
    const SetsOff sets_off = changed.declaration(set.name).sets_off;
    // Who sets it by hand takes over from its table.
    std::vector<Drive> drives = moment_.drives;
    place_drive(drives, {set.name, {}});
    fit(terrain_.grid(), changed, drives);
    fit_events(terrain_.grid(), changed, drives, moment_.events);
    const bool fills = sets_off == SetsOff::sea && set.value;
    if (sets_off == SetsOff::sea) withdraw_sea(set.name);
    const auto change = [&] {
        if (keeps_undo_ && fills) undo_.keep_all(terrain_);
        if (sets_off == SetsOff::solid_weights) reweigh(changed);
        moment_.parameters = changed;
        moment_.drives = drives;
        if (sets_off == SetsOff::edge_clock) moment_.edges_since_s = moment_.clock.simulated_s;
        if (fills) fill_sea_now();
    };
    // A dragged slider extends its last undo entry. A sea that fills tiles needs an entry of its own.
    if (keeps_undo_ && !undo_.is_open() && !fills && undo_.extends(set.name, history_name(set))) {
        change();
        journal_.record(set);
    } else {
        record(set, change);
    }
    // Rest was decided under the old values.
    terrain_.tiles.mark_all();
}

void Simulation::act(const PlaceSpring& spring) {
    check_spring(terrain_.grid(), spring);
    record(spring, [&] { place_spring(terrain_.grid(), moment_.springs, spring); });
}

void Simulation::act(const SetEvents& wanted) {
    SetEvents set = wanted;
    check_events(moment_.parameters, terrain_.grid(), set.events);
    fit_events(terrain_.grid(), moment_.parameters, moment_.drives, set.events);
    record(set, [&] { moment_.events = set.events; });
}

void Simulation::act(const DriveParameter& wanted) {
    DriveParameter drive = wanted;
    const Parameter& declared = moment_.parameters.declaration(wanted.parameter);
    drive.parameter = declared.name;
    check_drive(moment_.parameters, drive);
    const bool ends = drive.series.empty();
    const bool is_sea = declared.sets_off == SetsOff::sea && !ends;
    Parameters changed = moment_.parameters;
    std::vector<Drive> drives = moment_.drives;
    place_drive(drives, drive);
    if (!ends) changed.set(drive.parameter, drive.series.at(moment_.clock.simulated_s));
    fit(terrain_.grid(), changed, drives);
    fit_events(terrain_.grid(), changed, drives, moment_.events);
    // A sea that begins to follow a table fills as one whose level is set.
    const bool withdrawn = is_sea && withdraw_sea(drive.parameter);
    const bool fills =
        is_sea && (withdrawn || !moment_.parameters.is_given(drive.parameter) ||
                   moment_.parameters.value(drive.parameter) != changed.value(drive.parameter));
    record(drive, [&] {
        if (keeps_undo_ && fills) undo_.keep_all(terrain_);
        moment_.parameters = changed;
        moment_.drives = drives;
        // What the parameter says without a table begins now.
        if (ends && declared.sets_off == SetsOff::edge_clock)
            moment_.edges_since_s = moment_.clock.simulated_s;
        if (fills) fill_sea_now();
    });
    terrain_.tiles.mark_all();
}

void Simulation::act(const Dab& wanted) {
    check_dab(wanted);
    Dab dab = wanted;
    for (const auto& pass : passes_) pass->complete(dab, moment_);
    record(dab, [&] {
        if (keeps_undo_) undo_.keep(terrain_, terrain_.tiles.touched_by(dab_region(terrain_.grid(), dab)));
        act_by_pass(dab);
    });
}

void Simulation::act_by_pass(const PassAct& act) {
    const bool done = std::any_of(passes_.begin(), passes_.end(),
                                  [&](const auto& pass) { return pass->act(terrain_, moment_, act); });
    if (!done) throw Error("no pass does this act");
}

void Simulation::act(const Resample& to) {
    replace_terrain(to, to.made ? *to.made : made_of(to, read()), moment_.parameters);
}

void Simulation::act(const Crop& crop) {
    replace_terrain(crop, crop.made ? *crop.made : made_of(crop, read()), moment_.parameters);
}

void Simulation::act(const Turn& turn) {
    Parameters parameters = moment_.parameters;
    TerrainState next = turn.made ? *turn.made : made_of(turn, read());
    for (const auto& pass : passes_) pass->turn(parameters, next.events, turn.quarters);
    replace_terrain(turn, next, parameters);
}

void Simulation::act(const Import& import) {
    if (!import.state)
        throw Error(fmt::format("'{}' was not read before it was imported", import.source.path));
    TerrainState next = *import.state;
    next.clock = moment_.clock;
    next.edges_since_s = moment_.edges_since_s;
    next.events = moment_.events;
    drop_breaches_beside(next.grid, next.events);
    if (moment_.parameters.is_given("water.sea_level_m") && next.water.empty())
        fill_sea(next, moment_.parameters.number("water.sea_level_m"));
    replace_terrain(import, next, moment_.parameters);
}

void Simulation::act(const ChooseStamp& choose) {
    std::shared_ptr<const Stamp> stamp = choose.stamp;
    if (choose.source.path.empty()) {
        const Grid& grid = terrain_.grid();
        const gpu::Region piece = samples_in(grid, choose.piece);
        std::vector<float> heights(static_cast<std::size_t>(piece.width) * piece.height);
        terrain_.ground.read(piece, std::as_writable_bytes(std::span(heights)));
        stamp = std::make_shared<Stamp>(stamp_of({piece.width, piece.height, grid.dx, grid.dy}, heights));
    }
    if (!stamp) throw Error(fmt::format("'{}' was not read before it became the stamp", choose.source.path));
    record(choose, [&] { moment_.stamp = stamp; });
}

void Simulation::act(const MakeMask& make) {
    check_mask(make);
    record(make, [&] {
        if (keeps_undo_) undo_.keep_all(terrain_);
        act_by_pass(make);
    });
}

void Simulation::act(const Blur& blur) {
    const TerrainState blurred = blur.made ? *blur.made : made_of(blur, read());
    record(blur, [&] {
        if (keeps_undo_) undo_.keep_all(terrain_);
        if (blur.of_mask)
            terrain_.write(&Terrain::painted, blurred);
        else
            book([&] { terrain_.write_solid(blurred); });
        if (!blur.of_mask && counts_maps(moment_.parameters)) terrain_.write(&Terrain::worn_by_hand, blurred);
    });
}

void Simulation::act(const TakeRaster& take) {
    if (!take.values) throw Error(fmt::format("'{}' was not read before it was taken", take.source.path));
    const PaintedNumberDescription& number = painted_number_named(take.number);
    TerrainState state;
    state.grid = terrain_.grid();
    terrain_.read(number.layer(), state);
    try {
        take_values(state, number, *take.values);
    } catch (const Error& error) {
        throw Error(fmt::format("'{}' {}", take.source.path, error.what()));
    }
    record(take, [&] {
        if (keeps_undo_) undo_.keep_all(terrain_);
        terrain_.write(number.layer().image, state);
    });
}

void Simulation::replace_terrain(const Operation& operation, const TerrainState& next,
                                 Parameters parameters) {
    if (undo_.is_open())
        throw Error(fmt::format("a stroke or run is not ended: {} needs that", name_of(operation)));
    fit(next.grid, parameters, moment_.drives);
    fit_events(next.grid, parameters, moment_.drives, next.events);
    Site site{Terrain(next)};
    // Water that came with it has arrived.
    for (const auto& pass : site.passes) pass->observe(site.terrain, moment_);
    const LedgerStart start = site.ledger->begin(site.terrain, solid_weights(parameters));
    std::vector<Spring> springs = next.springs;
    std::vector<Event> events = next.events;
    std::optional<Georeference> georeference = next.georeference;
    record(operation, [&] {
        // What may fail comes first.
        if (keeps_undo_) undo_.keep_terrain(pack(terrain_));
        stand_on(std::move(site));
        moment_.parameters = std::move(parameters);
        moment_.springs = std::move(springs);
        moment_.events = std::move(events);
        moment_.georeference = std::move(georeference);
        moment_.sea_m3 = 0;
        moment_.booked_m3 = 0;
        moment_.ledger = start;
    });
}

void Simulation::stand_on(Site site) {
    asked_.sums.cancel();
    forget_asked_sections();
    terrain_ = std::move(site.terrain);
    passes_ = std::move(site.passes);
    ledger_ = std::move(site.ledger);
    ++terrain_number_;
}

bool Simulation::withdraw_sea(const std::string& level) {
    const std::vector<Operation>& done = journal_.operations();
    if (undo_.is_open() || !can_undo() || done.empty()) return false;
    const auto* set = std::get_if<SetParameter>(&done.back());
    const auto* drive = std::get_if<DriveParameter>(&done.back());
    const bool filled = (set && set->name == level && set->value) ||
                        (drive && drive->parameter == level && !drive->series.empty());
    if (!filled || undo_.undo_name() != history_name(done.back())) return false;
    exchange(false);
    return true;
}

void Simulation::begin_stroke(const std::string& name) {
    if (!keeps_undo_) return;
    end_entry();
    undo_.open(name, terrain_, journal_, snapshot());
}

void Simulation::end_entry() {
    const std::string run = name_of(Ticks());
    if (undo_.is_open() && undo_.undo_name() == run) {
        const double ran_s = moment_.clock.simulated_s - undo_.before().moment.clock.simulated_s;
        undo_.rename_open(fmt::format("{} of {} s", run, figure(ran_s, 4)));
    }
    undo_.close(terrain_, journal_);
}

void Simulation::exchange(bool forth) {
    Snapshot now = snapshot();
    const Snapshot& wanted = forth ? undo_.after() : undo_.before();
    // What may fail comes first.
    std::optional<Site> site;
    if (wanted.terrain) {
        now.terrain = pack(terrain_);
        site.emplace(unpack(*wanted.terrain));
    }
    Snapshot then = [&] {
        if (forth) return undo_.redo(terrain_, journal_, std::move(now));
        return undo_.undo(terrain_, journal_, std::move(now));
    }();
    if (site) stand_on(std::move(*site));
    then.books.put_back(books());
    moment_ = std::move(then.moment);
    for (const auto& pass : passes_) pass->forget_act();
    terrain_.tiles.mark_all();
}

void Simulation::undo() {
    while (mid_tick()) advance(1 << 20);
    end_entry();
    if (can_undo()) exchange(false);
}

void Simulation::redo() {
    while (mid_tick()) advance(1 << 20);
    end_entry();
    if (can_redo()) exchange(true);
}

void Simulation::take_back_entry() {
    if (!undo_.is_open()) return;
    // Where nothing was done, what could be redone still can.
    if (!mid_tick() && undo_.is_empty(journal_)) return undo_.abandon();
    in_tick_ = false;
    // So that it is kept though nothing of it was recorded so far; and it is undone at once.
    journal_.record(Ticks{1});
    end_entry();
    exchange(false);
    undo_.forget_undone();
}

void Simulation::copy_books(AskedLedger& asked) {
    asked.books = BookCopies(books());
    asked.weights = solid_weights(moment_.parameters);
    asked.sea_m3 = moment_.sea_m3;
    asked.booked_m3 = moment_.booked_m3;
    asked.start = moment_.ledger;
}

LedgerReading Simulation::reading_of(const AskedLedger& asked,
                                     const std::vector<glm::dvec4>& tile_sums) const {
    BudgetTerms terms = asked.books.terms(terrain_.grid(), asked.weights);
    terms.water.sea_m3 = asked.sea_m3;
    (asked.booked_m3 > 0 ? terms.solid_in_m3 : terms.solid_out_m3) += std::abs(asked.booked_m3);
    return ledger_->reading(asked.start, tile_sums, asked.weights, terms);
}

LedgerReading Simulation::ledger() {
    // What was asked for before is older.
    asked_.sums.cancel();
    AskedLedger asked;
    copy_books(asked);
    ledger_->sum(terrain_);
    return reading_of(asked, ledger_->tile_sums().read_all<glm::dvec4>());
}

void Simulation::ask_ledger() {
    if (mid_tick() || asked_.sums.pending()) return;
    copy_books(asked_);
    ledger_->sum(terrain_);
    asked_.sums.start(ledger_->tile_sums(), ledger_->tile_sums().bytes());
}

std::optional<LedgerReading> Simulation::poll_ledger() {
    // The books were copied before the sums, so they are there when these are.
    const std::optional<std::vector<float>> words = asked_.sums.poll();
    if (!words) return std::nullopt;
    std::vector<glm::dvec4> tile_sums(words->size() * sizeof(float) / sizeof(glm::dvec4));
    std::memcpy(tile_sums.data(), words->data(), tile_sums.size() * sizeof(glm::dvec4));
    return reading_of(asked_, tile_sums);
}

void Simulation::reweigh(const Parameters& changed) {
    Parameters present = changed;
    book([&] { std::swap(moment_.parameters, present); });
    std::swap(moment_.parameters, present);
}

template <typename Change>
void Simulation::book(Change&& change) {
    const double before = ledger().closing_error_m3();
    change();
    moment_.booked_m3 += ledger().closing_error_m3() - before;
}

void Simulation::follow_sections(const std::vector<Section>& sections) {
    for (const auto& pass : passes_) pass->follow_sections(terrain_, sections);
    forget_asked_sections();
}

std::vector<double> Simulation::section_volumes_of(std::span<const double> words) const {
    for (const auto& pass : passes_) {
        std::vector<double> volumes = pass->section_volumes_m3(terrain_.grid(), words);
        if (!volumes.empty()) return volumes;
    }
    return {};
}

std::vector<double> Simulation::section_volumes_m3() const {
    for (const auto& pass : passes_)
        if (const std::optional<gpu::Buffer> words = pass->section_words())
            return section_volumes_of(words->read_all<double>());
    return section_volumes_of({});
}

void Simulation::ask_section_volumes() {
    forget_asked_sections();
    asked_sections_ = true;
    for (const auto& pass : passes_)
        if (std::optional<gpu::Buffer> words = pass->section_words()) section_words_.start(std::move(*words));
}

std::optional<std::vector<double>> Simulation::poll_section_volumes() {
    if (!asked_sections_) return std::nullopt;
    std::vector<double> words;
    if (section_words_.pending()) {
        const auto bits = section_words_.poll();
        if (!bits) return std::nullopt;
        words.resize(bits->size() / 2);
        std::memcpy(words.data(), bits->data(), words.size() * sizeof(double));
    }
    asked_sections_ = false;
    return section_volumes_of(words);
}

void Simulation::forget_asked_sections() {
    section_words_.cancel();
    asked_sections_ = false;
}

PassWork Simulation::work(const std::string& name) const {
    for (const auto& pass : passes_)
        if (pass->name() == name) return pass->work();
    throw Error(fmt::format("there is no pass '{}'", name));
}

TerrainState Simulation::with_moment(TerrainState layers) const {
    layers.clock = moment_.clock;
    layers.springs = moment_.springs;
    layers.drives = moment_.drives;
    layers.events = moment_.events;
    layers.edges_since_s = moment_.edges_since_s;
    layers.georeference = moment_.georeference;
    return layers;
}

TerrainState Simulation::moment_state() const {
    TerrainState none;
    none.grid = terrain_.grid();
    return with_moment(std::move(none));
}

TerrainState Simulation::read() const {
    return with_moment(terrain_.read());
}

}  // namespace talus

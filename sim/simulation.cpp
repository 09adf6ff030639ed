#include "sim/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>
#include <utility>

#include "sim/gpu/error.h"
#include "sim/terrain/sea.h"

namespace talus {
namespace {

// Unless somebody set it, thermal erosion's rate makes a tick one sub-step.
void suggest_slope_rate(const Grid& grid, Parameters& parameters) {
    parameters.suggest("thermal.rate_m2_per_s", natural_thermal_rate(grid, parameters.number("time.tick_s"),
                                                                     parameters.number("erosion.porosity")));
}

}  // namespace

Simulation::Simulation(const TerrainState& state, const Parameters& parameters, std::size_t undo_bytes)
    : terrain_(state),
      brush_(terrain_),
      thermal_(terrain_),
      moment_{state.clock, parameters,         state.springs, state.edges_since_s, 0, 0,
              {},          state.georeference, nullptr},
      undo_(undo_bytes),
      keeps_undo_(undo_bytes > 0) {
    suggest_slope_rate(state.grid, moment_.parameters);
    check_tick(state.grid, moment_.parameters);
    if (terrain_.water) {
        add_water();
        inundation_->record(terrain_, moment_.clock.simulated_s);
    }
    rain_painted_ = std::any_of(state.painted.begin(), state.painted.end(),
                                [](const glm::vec4& painted) { return painted.z > 0; });
    // What was saved midway holds what is left of its sea.
    if (state.clock.ticks == 0 && moment_.parameters.is_given("water.sea_level_m")) fill_sea_now();
    moment_.sea_m3 = 0;
    ledger_ = std::make_unique<Ledger>(terrain_);
    moment_.ledger = ledger_->begin(terrain_, weights_of(sediment_settings(moment_.parameters)));
}

Books Simulation::books() {
    Books books = {&brush_.books};
    if (water_) {
        for (gpu::Buffer* book : water_->books()) books.push_back(book);
        books.push_back(&water_brush_->books);
    }
    return books;
}

bool Simulation::has_water() const {
    const Parameters& parameters = moment_.parameters;
    if (!parameters.toggle("water.on")) return false;
    if (water_ || !moment_.springs.empty() || parameters.number("water.rain_mm_per_h") > 0) return true;
    if (rain_painted_) return true;
    const WaterSettings settings = water_settings_of(parameters);
    return std::any_of(settings.edges.begin(), settings.edges.end(), [&](EdgeKind kind) {
        return kind == EdgeKind::inflow || kind == EdgeKind::level || kind == EdgeKind::wave;
    });
}

void Simulation::add_water() {
    terrain_.add(&Terrain::water);
    if (water_) return;
    water_ = std::make_unique<Water>(terrain_);
    water_brush_ = std::make_unique<WaterBrush>(terrain_);
    inundation_ = std::make_unique<Inundation>(terrain_);
}

WaterSettings Simulation::water_settings() const {
    WaterSettings settings = water_settings_of(moment_.parameters);
    settings.rain_masked = settings.rain_masked && settings.rain_m_per_s > 0;
    // Where nothing was painted the mask is 0, and no rain falls by it.
    if (settings.rain_masked && !terrain_.painted) settings.rain_m_per_s = 0;
    SedimentSettings& sediment = settings.sediment;
    sediment.carried = terrain_.suspended.has_value();
    if (sediment.masked && !terrain_.painted) sediment.regolith_m_per_s_pa = sediment.bedrock_m_per_s_pa = 0;
    settings.rain_painted = rain_painted_ && terrain_.painted.has_value();
    return settings;
}

void Simulation::fill_sea_now() {
    TerrainState state = terrain_.read();
    moment_.sea_m3 += fill_sea(state, moment_.parameters.number("water.sea_level_m"));
    add_water();
    terrain_.write(&Terrain::water, state);
    inundation_->record(terrain_, moment_.clock.simulated_s);
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

template <typename Change>
void Simulation::record(const Operation& operation, Change&& change) {
    const bool entry = keeps_undo_ && !undo_.is_open();
    if (entry) undo_.open(name_of(operation), terrain_, books(), journal_, moment_);
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
    suggest_slope_rate(terrain_.grid(), changed);
    check_tick(terrain_.grid(), changed);
    const bool fills = sets_off == SetsOff::sea && set.value;
    if (sets_off == SetsOff::sea) withdraw_sea(set.name);
    const auto change = [&] {
        if (keeps_undo_ && fills) undo_.keep_all(terrain_);
        if (sets_off == SetsOff::solid_weights) reweigh(changed);
        moment_.parameters = changed;
        if (sets_off == SetsOff::edge_clock) moment_.edges_since_s = moment_.clock.simulated_s;
        if (fills) fill_sea_now();
    };
    // A slider that is dragged is one entry; a sea that rises keeps what it covers.
    if (keeps_undo_ && !undo_.is_open() && !fills && undo_.extends(set.name)) {
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
    record(spring, [&] { place(spring); });
}

void Simulation::act(const Dab& wanted) {
    check_dab(wanted);
    Dab dab = wanted;
    if (dab.mode == BrushMode::erode && !(erode_brush_ && erode_brush_->is_going())) dab.erode.begins = true;
    if (dab.mode == BrushMode::stamp && !moment_.stamp)
        throw Error("there is no stamp yet: choose a file or a piece of the terrain first");
    if (dab.is_water()) add_water();
    if (dab.is_paint() && dab.material == Material::rain) rain_painted_ = true;
    record(dab, [&] {
        if (keeps_undo_) undo_.keep(terrain_, terrain_.tiles.touched_by(dab_region(terrain_.grid(), dab)));
        // Where nothing was painted the mask is 0.
        if (dab.masked && !terrain_.painted && dab.mode != BrushMode::erode) return;
        if (dab.is_paint()) {
            paint_.dab(terrain_, dab);
        } else if (dab.is_water()) {
            water_brush_->dab(terrain_, dab);
            inundation_->record(terrain_, moment_.clock.simulated_s);
        } else if (dab.mode == BrushMode::stamp) {
            brush_.dab(terrain_, dab, &stamp_texture());
        } else if (dab.mode == BrushMode::erode) {
            erode(dab);
        } else {
            brush_.dab(terrain_, dab);
        }
    });
}

void Simulation::erode(const Dab& dab) {
    if (!erode_brush_) erode_brush_ = std::make_unique<ErodeBrush>();
    Parameters parameters = moment_.parameters;
    parameters.set("erosion.on", true);
    std::optional<ThermalSettings> thermal;
    if (parameters.toggle("thermal.on")) thermal = thermal_settings(parameters);
    const Terrain& eroded = erode_brush_->erode(terrain_, dab, water_settings_of(parameters), thermal);
    const double settled =
        dab.erode.ends ? dab.erode.acceleration * bulking_of(parameters.number("erosion.porosity")) : 0;
    brush_.take_over(terrain_, dab, eroded, settled);
    erode_brush_->set_going(!dab.erode.ends);
}

const gpu::Texture& Simulation::stamp_texture() {
    if (stamp_there_ != moment_.stamp) {
        const Stamp& stamp = *moment_.stamp;
        stamp_texture_ = gpu::Texture("stamp", gpu::Format::r32f, stamp.grid.nx, stamp.grid.ny);
        stamp_texture_.write(stamp_texture_.whole(), std::as_bytes(std::span(stamp.heights)));
        stamp_there_ = moment_.stamp;
    }
    return stamp_texture_;
}

void Simulation::act(const Resample& to) {
    replace_terrain(to, to.made ? *to.made : made_of(to, read()), moment_.parameters);
}

void Simulation::act(const Crop& crop) {
    replace_terrain(crop, crop.made ? *crop.made : made_of(crop, read()), moment_.parameters);
}

void Simulation::act(const Turn& turn) {
    // What was east is north after a quarter.
    constexpr std::array around = {Edge::east, Edge::north, Edge::west, Edge::south};
    Parameters parameters = moment_.parameters;
    const int quarters = (turn.quarters % 4 + 4) % 4;
    for (std::size_t i = 0; i < 4; ++i) {
        const std::string& from = boundary_parameter(around[i]);
        const std::string& to = boundary_parameter(around[(i + static_cast<std::size_t>(quarters)) % 4]);
        if (moment_.parameters.value(from) != moment_.parameters.value(to))
            parameters.set(to, moment_.parameters.value(from));
    }
    replace_terrain(turn, turn.made ? *turn.made : made_of(turn, read()), parameters);
}

void Simulation::act(const Import& import) {
    if (!import.state)
        throw Error(fmt::format("'{}' was not read before it was imported", import.source.path));
    TerrainState next = *import.state;
    next.clock = moment_.clock;
    next.edges_since_s = moment_.edges_since_s;
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
        mask_.make(terrain_, make);
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
    });
}

void Simulation::replace_terrain(const Operation& operation, const TerrainState& next,
                                 Parameters parameters) {
    if (undo_.is_open())
        throw Error(fmt::format("a stroke or run is not ended: {} needs that", name_of(operation)));
    suggest_slope_rate(next.grid, parameters);
    check_tick(next.grid, parameters);
    Terrain terrain(next);
    // Water that came with it has arrived.
    if (terrain.water) Inundation(terrain).record(terrain, moment_.clock.simulated_s);
    const LedgerStart start = Ledger(terrain).begin(terrain, weights_of(sediment_settings(parameters)));
    std::vector<Spring> springs = next.springs;
    std::optional<Georeference> georeference = next.georeference;
    record(operation, [&] {
        // What may fail comes first.
        if (keeps_undo_) undo_.keep_terrain(pack(terrain_));
        stand_on(std::move(terrain));
        moment_.parameters = std::move(parameters);
        moment_.springs = std::move(springs);
        moment_.georeference = std::move(georeference);
        moment_.sea_m3 = 0;
        moment_.booked_m3 = 0;
        rain_painted_ = rain_painted_ || terrain_.painted.has_value();
        moment_.ledger = start;
    });
}

void Simulation::stand_on(Terrain next) {
    Brush brush(next);
    Thermal thermal(next);
    auto ledger = std::make_unique<Ledger>(next);
    std::unique_ptr<Water> water;
    std::unique_ptr<WaterBrush> water_brush;
    std::unique_ptr<Inundation> inundation;
    if (next.water) {
        water = std::make_unique<Water>(next);
        water_brush = std::make_unique<WaterBrush>(next);
        inundation = std::make_unique<Inundation>(next);
    }
    asked_.sums.cancel();
    erode_brush_.reset();
    water_ = std::move(water);
    water_brush_ = std::move(water_brush);
    inundation_ = std::move(inundation);
    terrain_ = std::move(next);
    brush_ = std::move(brush);
    thermal_ = std::move(thermal);
    ledger_ = std::move(ledger);
    ++terrain_number_;
}

void Simulation::withdraw_sea(const std::string& level) {
    const std::vector<Operation>& done = journal_.operations();
    const auto* last = done.empty() ? nullptr : std::get_if<SetParameter>(&done.back());
    if (undo_.is_open() || !can_undo() || undo_.undo_name() != level) return;
    if (last && last->name == level && last->value) exchange(&Undo::undo);
}

void Simulation::place(const Spring& spring) {
    const Grid& grid = terrain_.grid();
    const auto sample = [&](const Spring& s) {
        return glm::dvec2(std::round(grid.column_of(s.x_m)), std::round(grid.row_of(s.y_m)));
    };
    std::vector<Spring>& springs = moment_.springs;
    springs.erase(std::remove_if(springs.begin(), springs.end(),
                                 [&](const Spring& s) { return sample(s) == sample(spring); }),
                  springs.end());
    if (spring.rate_m3_per_s > 0) springs.push_back(spring);
}

void Simulation::check_tick(const Grid& grid, const Parameters& parameters) const {
    if (parameters.toggle("thermal.on"))
        thermal_substeps(grid, thermal_settings(parameters), parameters.number("time.tick_s"));
}

void Simulation::begin_tick() {
    const Parameters& parameters = moment_.parameters;
    const double tick_s = parameters.number("time.tick_s");
    if (has_water()) add_water();
    if (has_water() && parameters.toggle("erosion.on")) terrain_.add(&Terrain::suspended);
    if (keeps_undo_) {
        if (!undo_.is_open()) undo_.open("run", terrain_, books(), journal_, moment_);
        undo_.keep_all(terrain_);
    }
    thermal_left_ = 0;
    if (parameters.toggle("thermal.on")) {
        const ThermalSettings settings = thermal_settings(parameters);
        thermal_left_ = thermal_substeps(terrain_.grid(), settings, tick_s);
        step_ = thermal_step(terrain_.grid(), settings, tick_s, thermal_left_);
    }
    water_begun_ = false;
    in_tick_ = true;
}

bool Simulation::advance(int substeps) {
    if (!in_tick_) begin_tick();
    for (; substeps > 0 && thermal_left_ > 0; --substeps, --thermal_left_, ++thermal_sent_)
        thermal_.substep(terrain_, step_);
    if (thermal_left_ > 0) return false;
    const double tick_s = moment_.parameters.number("time.tick_s");
    if (has_water()) {
        // The water finds the ground as the tick's slides left it.
        if (!water_begun_)
            water_->begin_tick(terrain_, water_settings(), moment_.springs, tick_s,
                               moment_.clock.simulated_s - moment_.edges_since_s);
        water_begun_ = true;
        if (!water_->advance(terrain_, substeps)) return false;
        inundation_->record(terrain_, moment_.clock.simulated_s + tick_s);
    }
    in_tick_ = false;
    moment_.clock.ticks += 1;
    moment_.clock.simulated_s += tick_s;
    journal_.record(Ticks{1});
    return true;
}

void Simulation::begin_stroke(const std::string& name) {
    if (!keeps_undo_) return;
    end_entry();
    undo_.open(name, terrain_, books(), journal_, moment_);
}

void Simulation::end_entry() {
    undo_.close(terrain_, journal_);
}

void Simulation::exchange(UndoWay way) {
    (undo_.*way)(
        terrain_, [this] { return books(); }, journal_, moment_,
        [this](const PackedTerrain& other) {
            PackedTerrain present = pack(terrain_);
            stand_on(unpack(other));
            return present;
        });
    // Its water belongs to acts that may be undone now.
    if (erode_brush_) erode_brush_->set_going(false);
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

void Simulation::copy_books(AskedLedger& asked) {
    asked.books.clear();
    for (const gpu::Buffer* book : books()) {
        asked.books.emplace_back("ledger books", book->bytes());
        asked.books.back().copy_from(*book);
    }
    asked.weights = weights_of(sediment_settings(moment_.parameters));
    asked.sea_m3 = moment_.sea_m3;
    asked.booked_m3 = moment_.booked_m3;
    asked.start = moment_.ledger;
}

LedgerReading Simulation::reading_of(const AskedLedger& asked,
                                     const std::vector<glm::dvec4>& tile_sums) const {
    // In the order of books(): the brush's; where there is water, four of its, and its brush's.
    const std::vector<gpu::Buffer>& books = asked.books;
    WaterBooks water;
    glm::dvec2 solid_edges(0);
    if (books.size() == 6) {
        const double area = terrain_.grid().dx * terrain_.grid().dy;
        water = Water::read_books(books[1], books[2], books[3], terrain_.grid());
        for (const glm::dvec2& sample : books[4].read_all<glm::dvec2>()) solid_edges += sample;
        for (const glm::dvec2& book : books[5].read_all<glm::dvec2>()) {
            water.brush_in_m3 += book.x * area;
            water.brush_out_m3 += book.y * area;
        }
    }
    water.sea_m3 = asked.sea_m3;
    return ledger_->reading(asked.start, tile_sums, asked.weights, books[0], water, solid_edges,
                            asked.booked_m3);
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

Water::Work Simulation::water_work() const {
    return water_ ? water_->work() : Water::Work();
}

TerrainState Simulation::moment_state() const {
    TerrainState state;
    state.grid = terrain_.grid();
    state.clock = moment_.clock;
    state.springs = moment_.springs;
    state.edges_since_s = moment_.edges_since_s;
    state.georeference = moment_.georeference;
    return state;
}

TerrainState Simulation::read() const {
    TerrainState state = terrain_.read();
    const TerrainState moment = moment_state();
    state.clock = moment.clock;
    state.springs = moment.springs;
    state.edges_since_s = moment.edges_since_s;
    state.georeference = moment.georeference;
    return state;
}

}  // namespace talus

#include "app/session.h"

#include "app/still.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>
#include <utility>

#include "app/calibration.h"
#include "app/outputs.h"
#include "app/wall_clock.h"
#include "app/wave_note.h"
#include "render/overview.h"
#include "sim/error.h"
#include "sim/io/atomic_file.h"
#include "sim/io/endings.h"
#include "sim/passes/erode_brush.h"
#include "sim/preset.h"
#include "sim/terrain/state_hash.h"

namespace talus {
Session::Session(const SceneRequest& request, gpu::Device device)
    : device_(std::move(device)), request_(request), scene_(make_scene(request)) {
    start(std::move(scene_));
    path_ = document_path();
}

void Session::start(Scene scene) {
    scene.start.hash = state_hash(scene.document.state);
    const std::size_t undo_bytes = static_cast<std::size_t>(scene.view.whole("undo.memory_mib")) << 20U;
    auto simulation = std::make_unique<Simulation>(scene.document.state, scene.simulation, undo_bytes);
    auto renderer = std::make_unique<Renderer>(simulation->terrain(), patch_pixels(device_));
    drape(*renderer, scene);
    const std::vector<float> ground = scene.document.state.ground();
    const auto [low, high] = std::minmax_element(ground.begin(), ground.end());
    bounds_ = {*low, *high};
    scene_ = std::move(scene);
    ++terrain_number_;
    simulation_ = std::move(simulation);
    renderer_ = std::move(renderer);
    wave_note_ = talus::wave_note(scene_.document.state, simulation_->parameters());
    gauges_ = Gauges(grid());
    balances_.clear();
    ledger_of_changes_ = 0;
    saved_operations_.clear();
    recovered_ = false;
    compared_revision_.reset();
    stamps_.cancel();
    activity_since_ = activity_asked_at_ = {};
    activity_ = {};
    playing = false;
    stroke_.reset();
    simulated_terrain_ = simulation_->terrain_number();
    forget_rectangle();
    suggest_for_terrain();
    frame_terrain();
}

// What was said of another terrain's size and place is not of this one.
void Session::forget_rectangle() {
    for (const char* name : {"map.nx", "map.ny", "map.west_m", "map.south_m", "map.east_m", "map.north_m"})
        scene_.view.reset(name);
}

void Session::suggest_for_terrain() {
    const Grid& g = grid();
    const double extent = std::max(g.width_m(), g.height_m());
    scene_.view.suggest("brush.radius_m", extent / 40);
    scene_.view.suggest("brush.rate_m_per_s", extent / 160);
    scene_.view.suggest("camera.speed_m_per_s", extent / 12);
    scene_.view.suggest("erode.speed", 6 * std::min(g.dx, g.dy));
    scene_.view.suggest("noise.wavelength_m", extent / 12);
    scene_.view.suggest("map.nx", g.nx);
    scene_.view.suggest("map.ny", g.ny);
    scene_.view.suggest("map.east_m", g.width_m());
    scene_.view.suggest("map.north_m", g.height_m());
    scene_.view.suggest("terrace.step_m", std::max(0.01, (bounds_.y - bounds_.x) / 20));
    scene_.view.suggest("brush.height_m", bounds_.x);
    scene_.view.suggest("map.base_m", bounds_.x);
    scene_.view.suggest("render.level_m", simulation_->parameters().number("water.sea_level_m"));
    if (const Stamp* stamp = simulation_->stamp().get())
        scene_.view.suggest("stamp.relief_m", stamp->relief_m);
}

void Session::follow_terrain() {
    if (simulated_terrain_ == simulation_->terrain_number()) return;
    simulated_terrain_ = simulation_->terrain_number();
    ++terrain_number_;
    const glm::dvec2 extent_before(scene_.document.state.grid.width_m(),
                                   scene_.document.state.grid.height_m());
    renderer_ = std::make_unique<Renderer>(simulation_->terrain(), patch_pixels(device_));
    const std::vector<float> ground = simulation_->terrain().ground.read_all<float>();
    const auto [low, high] = std::minmax_element(ground.begin(), ground.end());
    bounds_ = {*low, *high};
    scene_.document.state.grid = grid();
    // A picture over the terrain before is not one over this.
    scene_.texture = {};
    gauges_ = Gauges(grid());
    balances_.clear();
    ledger_of_changes_ = 0;
    stamps_.cancel();
    activity_since_ = activity_asked_at_ = {};
    forget_rectangle();
    suggest_for_terrain();
    if (extent_before != glm::dvec2(grid().width_m(), grid().height_m())) frame_terrain();
}

void Session::frame_terrain() {
    camera_ = overview(grid(), bounds_.x, bounds_.y, {picture_aspect, scene_.view.number("camera.fov_deg")});
}

SceneRequest Session::request_for(const SceneRequest& wish) const {
    SceneRequest request = request_;
    request.input = wish.input;
    // The preset that the window began with may be made for other ground: an opened file brings its own
    // settings.
    request.preset = wish.preset;
    request.import = wish.import;
    // What the command line set was meant for the scene that it named.
    request.size.reset();
    request.assignments.clear();
    // An image over one terrain is not one over another.
    if (wish.input != request_.input) request.texture.clear();
    return request;
}

void Session::open(const SceneRequest& request, Scene scene) {
    start(std::move(scene));
    request_ = request;
    path_ = document_path();
}

void Session::recovered(const std::string& project, const std::string& title) {
    path_ = project;
    scene_.title = title;
    recovered_ = true;
    // What lies in the recovery folder is no file to come back to.
    request_.input = project;
}

bool Session::unsaved() const {
    if (recovered_) return true;
    if (compared_revision_ != revision()) {
        compared_revision_ = revision();
        unsaved_ = simulation_->journal().operations() != saved_operations_;
    }
    return unsaved_;
}

std::string Session::document_path() const {
    return scene_.document.kind == "Talus document" ? request_.input : "";
}

void Session::reset() {
    start(make_scene(request_));
    path_ = document_path();
}

Document Session::document() {
    while (simulation_->mid_tick()) simulation_->advance(1 << 20);
    scene_.document.state = simulation_->read();
    scene_.document.parameters = to_toml(simulation_->parameters());
    return scene_.document;
}

void Session::saved(const std::string& path, std::size_t revision_then) {
    // Other formats hold the ground alone: what was saved there is an export.
    if (ending_of(path) != ".exr") return;
    path_ = path;
    scene_.title = std::filesystem::path(path).filename().string();
    if (recovered_) request_.input = path;
    recovered_ = false;
    // What was done while it was written is not saved.
    if (revision_then == revision()) saved_operations_ = simulation_->journal().operations();
    compared_revision_.reset();
}

void Session::write_journal_to(const std::string& path) const {
    write_atomically(path, write_journal(scene_.start, simulation_->journal()));
}

bool Session::is_simulated(const std::string& name) const {
    const auto& declared = simulation_->parameters().declared();
    return std::any_of(declared.begin(), declared.end(), [&](const Parameter& p) { return p.name == name; });
}

void Session::set(const std::string& name, const Value& value) {
    if (is_simulated(name)) return set_simulated(name, value);
    scene_.view.set(name, value);
    follow_undo_memory();
}

void Session::unset(const std::string& name) {
    if (is_simulated(name)) return set_simulated(name, std::nullopt);
    scene_.view.reset(name);
    suggest_for_terrain();
    follow_undo_memory();
}

void Session::follow_undo_memory() {
    simulation_->set_undo_capacity(static_cast<std::size_t>(scene_.view.whole("undo.memory_mib")) << 20U);
}

void Session::set_simulated(const std::string& name, const std::optional<Value>& value) {
    while (simulation_->mid_tick()) simulation_->advance(1 << 20);
    simulation_->apply(SetParameter{name, value});
    if (name.starts_with("water."))
        wave_note_ = talus::wave_note(scene_.document.state, simulation_->parameters());
}

const Value& Session::value(const std::string& name) const {
    return is_simulated(name) ? simulation_->parameters().value(name) : scene_.view.value(name);
}

bool Session::is_given(const std::string& name) const {
    return is_simulated(name) ? simulation_->parameters().is_given(name) : scene_.view.is_given(name);
}

const Parameter& Session::declaration(const std::string& name) const {
    return is_simulated(name) ? simulation_->parameters().declaration(name) : scene_.view.declaration(name);
}

void Session::play(double wall_s, double budget_s) {
    const double tick_s = simulation_->parameters().number("time.tick_s");
    const double speed = scene_.view.number("time.speed");
    const double simulated_before = simulation_->clock().simulated_s;
    // What could not be simulated in time is dropped, not piled up.
    owed_s_ = std::min(owed_s_ + wall_s * speed, std::max(tick_s, 0.25 * speed));
    // The device tells how long earlier ticks took; where it runs behind our back, the clock here would not.
    if (const auto ms = tick_timer_.milliseconds()) {
        if (timed_ticks_ > 0) tick_ms_ = *ms / timed_ticks_;
        if (timed_substeps_ > 0) substep_ms_ = *ms / static_cast<double>(timed_substeps_);
    }
    // A sub-step that does not fit waits until enough is saved. Under a hand whole ticks do: a tick that goes
    // on over frames would keep its dabs waiting.
    const double substep_s = substep_ms_ / 1000;
    const double needed_s = stroke_ && !simulation_->mid_tick() ? tick_ms_ / 1000 : substep_s;
    credit_s_ = std::min(credit_s_ + budget_s, std::max(budget_s, 1.2 * needed_s));
    if (needed_s > credit_s_) return;
    const double allowed_s = credit_s_;
    const double fitting = tick_ms_ > 0 ? std::floor(allowed_s * 1000 / tick_ms_) : 1;
    const double begin = wall_clock_s();
    const bool timing = !tick_timer_.pending();
    if (timing) tick_timer_.begin();
    const std::uint64_t sent_before = simulation_->substeps_sent();
    // Sub-steps go out in batches that fit the budget: each question for what is left costs a device that is
    // not this process more than a sub-step.
    const int batch =
        substep_ms_ > 0 ? static_cast<int>(std::clamp(allowed_s * 1000 / substep_ms_, 1.0, 64.0)) : 1;
    int ticks = 0;
    const auto fits = [&] {
        return (stroke_ && simulation_->mid_tick()) || wall_clock_s() - begin + substep_s <= allowed_s;
    };
    while (owed_s_ >= tick_s * 0.999 && ticks < std::max(1.0, fitting) && fits()) {
        if (!simulation_->advance(batch)) continue;
        owed_s_ -= tick_s;
        ++ticks;
        if (stroke_) break;
    }
    credit_s_ -= wall_clock_s() - begin;
    if (timing) {
        timed_ticks_ = ticks;
        timed_substeps_ = simulation_->substeps_sent() - sent_before;
        if (timed_substeps_ > 0) tick_timer_.end();
    }
    if (wall_s > 0) {
        const double reached = (simulation_->clock().simulated_s - simulated_before) / wall_s;
        speed_reached_ += 0.1 * (reached - speed_reached_);
    }
}

void Session::pause() {
    playing = false;
    speed_reached_ = 0;
    owed_s_ = 0;
    while (simulation_->mid_tick()) simulation_->advance(1 << 20);
    if (!stroke_) simulation_->end_entry();
}

void Session::toggle_play() {
    if (playing)
        pause();
    else
        playing = true;
}

void Session::step() {
    pause();
    simulation_->apply(Ticks{1});
    simulation_->end_entry();
}

Ring Session::ring(glm::dvec2 at_m) {
    Ring ring;
    ring.at_m = at_m;
    ring.radius_m = scene_.view.number("brush.radius_m");
    const std::shared_ptr<const Stamp>& stamp = simulation_->stamp();
    if (!stamp || tool_named(scene_.view.choice("brush.tool")).course != StrokeCourse::stamps) return ring;
    const Dab dab = tool_dab(scene_.view, {}, 0, 0, stamp.get());
    const DabStep step = dab_step(grid(), dab, {stamp->grid.nx, stamp->grid.ny});
    ring.radius_m = dab.radius_m;
    ring.stamp = &stamp_image_.of(stamp);
    // A dab counts rows southwards.
    ring.stamp_columns = {step.stamp_columns.x, -step.stamp_columns.y};
    ring.stamp_rows = {step.stamp_rows.x, -step.stamp_rows.y};
    return ring;
}

void Session::begin_stroke(glm::dvec3 at, const Modifiers& modifiers) {
    stroke_.emplace(scene_.view, modifiers, at, strokes_++);
    stroke_owed_s_ = 0;
    stroke_begun_ = false;
}

void Session::stroke(glm::dvec3 at, double wall_s) {
    stroke_owed_s_ += wall_s;
    if (simulation_->mid_tick()) return;
    if (!stroke_begun_) simulation_->begin_stroke(stroke_->name());
    stroke_begun_ = true;
    dabs_waited_s_ = stroke_owed_s_;
    std::vector<Dab> dabs =
        stroke_->move(scene_.view, at, std::exchange(stroke_owed_s_, 0), simulation_->stamp().get());
    for (Dab& dab : dabs) {
        // What a frame has no room for erodes more slowly.
        if (auto* erode = dab.as<ErodeDab>())
            erode->time_s = std::min(erode->time_s, erode_longest_s(grid(), dab));
        simulation_->apply(dab);
    }
    dabs_ += static_cast<int>(dabs.size());
}

void Session::end_stroke() {
    if (!stroke_) return;
    while (simulation_->mid_tick()) simulation_->advance(1 << 20);
    if (stroke_owed_s_ > 0) stroke(stroke_->at(), 0);
    const std::optional<Dab> last = stroke_->end(scene_.view);
    stroke_.reset();
    if (last) simulation_->apply(*last);
    simulation_->end_entry();
}

void Session::let_go_of_stroke() {
    if (!simulation_->mid_tick()) end_stroke();
}

void Session::apply(const Operation& operation) {
    end_stroke();
    pause();
    simulation_->apply(operation);
    simulation_->end_entry();
    suggest_for_terrain();
    follow_terrain();
}

void Session::balance() {
    while (simulation_->mid_tick()) simulation_->advance(1 << 20);
    keep_balance(simulation_->ledger(), simulation_->clock().simulated_s);
}

void Session::keep_balance(const LedgerReading& ledger, double simulated_s) {
    // Undo goes back in time.
    while (!balances_.empty() && balances_.back().simulated_s >= simulated_s) balances_.pop_back();
    // Every other one goes when there are too many for a plot.
    constexpr std::size_t room = 512;
    if (balances_.size() >= room) {
        for (std::size_t i = 1; 2 * i < balances_.size(); ++i) balances_[i] = balances_[2 * i];
        balances_.resize(balances_.size() / 2);
    }
    balances_.push_back({ledger, simulated_s});
}

void Session::follow_ledger() {
    if (const auto ledger = simulation_->poll_ledger()) keep_balance(*ledger, ledger_of_s_);
    if (simulation_->awaits_ledger() || simulation_->mid_tick()) return;
    const double simulated_s = simulation_->clock().simulated_s;
    const std::uint64_t changes = simulation_->terrain().tiles.now();
    if (wall_clock_s() - ledger_asked_at_s_ < 0.5 || changes == ledger_of_changes_) return;
    ledger_asked_at_s_ = wall_clock_s();
    ledger_of_s_ = simulated_s;
    ledger_of_changes_ = changes;
    simulation_->ask_ledger();
}

void Session::follow_activity() {
    const Tiles& tiles = simulation_->terrain().tiles;
    if (const auto words = stamps_.poll()) {
        std::vector<std::uint32_t> stamps(words->size());
        std::transform(words->begin(), words->end(), stamps.begin(),
                       [](float word) { return std::bit_cast<std::uint32_t>(word); });
        activity_ = {};
        for (std::size_t at = 0; at < stamps.size(); at += tile_changes::tile_kinds) {
            activity_.slope_tiles += tiles.has_changed(Tiles::ground, activity_since_, &stamps[at]) ? 1 : 0;
            activity_.water_tiles += tiles.has_changed(Tiles::water, activity_since_, &stamps[at]) ? 1 : 0;
        }
        activity_since_ = activity_asked_at_;
    }
    if (stamps_.pending() || wall_clock_s() - activity_asked_at_s_ < 0.5) return;
    activity_asked_at_s_ = wall_clock_s();
    activity_asked_at_ = tiles.reader_now();
    stamps_.start(tiles.stamps(), tiles.stamps().bytes());
}

void Session::follow_gauges() {
    // Within a tick the water is at no time of the clock's.
    if (!simulation_->mid_tick()) gauges_.follow(simulation_->terrain(), simulation_->clock().simulated_s);
}

void Session::undo() {
    end_stroke();
    pause();
    simulation_->undo();
    follow_terrain();
}

void Session::redo() {
    end_stroke();
    pause();
    simulation_->redo();
    follow_terrain();
}

void Session::go_to(std::size_t done) {
    end_stroke();
    pause();
    while (simulation_->can_undo() && simulation_->undo_history().done().size() > done) simulation_->undo();
    while (simulation_->can_redo() && simulation_->undo_history().done().size() < done) simulation_->redo();
    follow_terrain();
}

}  // namespace talus

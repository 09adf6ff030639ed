#include "app/session.h"

#include "app/still.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "app/calibration.h"
#include "app/outputs.h"
#include "app/wave_note.h"
#include "sim/gpu/error.h"
#include "sim/io/atomic_file.h"
#include "sim/preset.h"
#include "sim/terrain/state_hash.h"

namespace talus {
namespace {

double now_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

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
    playing = false;
    stroking_ = false;
    frame_terrain();
}

void Session::frame_terrain() {
    camera_ = overview(grid(), bounds_.x, bounds_.y);
}

void Session::open(const std::string& path, const ImportSettings& import) {
    SceneRequest request = request_;
    request.input = path;
    // The preset that the window began with may be made for other ground: an opened file brings its own
    // settings.
    if (request_.input.empty()) request.preset.clear();
    request.import = import;
    // An image over one terrain is not one over another.
    if (path != request_.input) request.texture.clear();
    start(make_scene(request));
    request_ = request;
    path_ = document_path();
}

std::string Session::document_path() const {
    return scene_.document.kind == "Talus document" ? request_.input : "";
}

void Session::reset() {
    start(make_scene(request_));
}

void Session::save(const std::string& path) {
    while (simulation_->mid_tick()) simulation_->advance(1 << 20);
    scene_.document.state = simulation_->read();
    scene_.document.parameters = to_toml(simulation_->parameters());
    write_terrain(path, scene_.document, "", std::nullopt);
    // Other formats hold the ground alone: what was saved there is an export.
    if (ending_of(path) != ".exr") return;
    path_ = path;
    saved_operations_ = simulation_->journal().operations();
}

void Session::write_journal_to(const std::string& path) const {
    write_atomically(path, write_journal(scene_.start, simulation_->journal()));
}

bool Session::is_simulated(const std::string& name) const {
    const auto& declared = simulation_->parameters().declared();
    return std::any_of(declared.begin(), declared.end(), [&](const Parameter& p) { return p.name == name; });
}

void Session::set(const std::string& name, const Value& value) {
    if (!is_simulated(name)) {
        scene_.view.set(name, value);
        if (name == "undo.memory_mib")
            simulation_->set_undo_capacity(static_cast<std::size_t>(scene_.view.whole(name)) << 20U);
        return;
    }
    while (simulation_->mid_tick()) simulation_->advance(1 << 20);
    simulation_->apply(SetParameter{name, value});
    if (name.starts_with("water."))
        wave_note_ = talus::wave_note(scene_.document.state, simulation_->parameters());
}

const Value& Session::value(const std::string& name) const {
    return is_simulated(name) ? simulation_->parameters().value(name) : scene_.view.value(name);
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
    const double fitting = tick_ms_ > 0 ? std::floor(budget_s * 1000 / tick_ms_) : 1;
    const double begin = now_s();
    const bool timing = !tick_timer_.pending();
    if (timing) tick_timer_.begin();
    const std::uint64_t sent_before = simulation_->substeps_sent();
    // Sub-steps go out in batches that fit the budget: each question for what is left costs a device that is
    // not this process more than a sub-step.
    const int batch =
        substep_ms_ > 0 ? static_cast<int>(std::clamp(budget_s * 1000 / substep_ms_, 1.0, 64.0)) : 1;
    int ticks = 0;
    while (owed_s_ >= tick_s * 0.999 && now_s() - begin < budget_s && ticks < std::max(1.0, fitting)) {
        if (!simulation_->advance(batch)) continue;
        owed_s_ -= tick_s;
        ++ticks;
    }
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
    if (!stroking_) simulation_->end_entry();
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

void Session::begin_stroke(glm::dvec3 at) {
    while (simulation_->mid_tick()) simulation_->advance(1 << 20);
    simulation_->begin_stroke(scene_.view.choice("brush.mode"));
    stroke_height_m_ = at.z;
    stroke_at_ = at;
    stroking_ = true;
}

void Session::stroke(glm::dvec3 at, double wall_s) {
    while (simulation_->mid_tick()) simulation_->advance(1 << 20);
    const Parameters& view = scene_.view;
    const auto& modes = view.declaration("brush.mode").choices;
    Dab dab;
    dab.mode = static_cast<BrushMode>(std::find(modes.begin(), modes.end(), view.choice("brush.mode")) -
                                      modes.begin());
    dab.radius_m = view.number("brush.radius_m");
    dab.falloff = view.number("brush.falloff");
    dab.target_m = stroke_height_m_;
    const auto& materials = view.declaration("brush.material").choices;
    dab.material = static_cast<Material>(
        std::find(materials.begin(), materials.end(), view.choice("brush.material")) - materials.begin());
    // A fast stroke is a row of dabs a quarter radius apart that share the time: its strength along the way
    // does not depend on how many frames it took.
    const double way_m = std::hypot(at.x - stroke_at_.x, at.y - stroke_at_.y);
    const int dabs = std::clamp(static_cast<int>(std::ceil(way_m / (0.25 * dab.radius_m))), 1, 64);
    if (dab.is_paint())
        dab.target_m = dab.mode == BrushMode::lower     ? 0
                       : dab.material == Material::rain ? view.number("brush.rain")
                                                        : 1;
    const double dab_s = wall_s / dabs;
    dab.amount_m = view.number("brush.rate_m_per_s") * dab_s;
    dab.blend = -std::expm1(-view.number("brush.blend_per_s") * dab_s);
    for (int i = 1; i <= dabs; ++i) {
        const glm::dvec3 place = stroke_at_ + (at - stroke_at_) * (static_cast<double>(i) / dabs);
        dab.x_m = place.x;
        dab.y_m = place.y;
        simulation_->apply(dab);
    }
    stroke_at_ = at;
}

void Session::end_stroke() {
    stroking_ = false;
    simulation_->end_entry();
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
    const std::uint64_t changes = simulation_->terrain().tiles.changes();
    if (now_s() - ledger_asked_at_s_ < 0.5 || changes == ledger_of_changes_) return;
    ledger_asked_at_s_ = now_s();
    ledger_of_s_ = simulated_s;
    ledger_of_changes_ = changes;
    simulation_->ask_ledger();
}

void Session::follow_gauges() {
    // Within a tick the water is at no time of the clock's.
    if (!simulation_->mid_tick()) gauges_.follow(simulation_->terrain(), simulation_->clock().simulated_s);
}

void Session::undo() {
    pause();
    simulation_->undo();
}

void Session::redo() {
    pause();
    simulation_->redo();
}

}  // namespace talus

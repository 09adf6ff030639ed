#include "app/core/session.h"
#include "app/core/first_look.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/core/calibration.h"
#include "app/core/opening.h"
#include "app/core/outlook.h"
#include "app/core/outputs.h"
#include "app/core/part.h"
#include "app/core/suggestions.h"
#include "app/core/wall_clock.h"
#include "app/core/wave_note.h"
#include "sim/error.h"
#include "sim/io/atomic_file.h"
#include "sim/io/endings.h"
#include "sim/preset.h"
#include "sim/terrain/state_hash.h"

namespace talus::app {
Session::Session(const SceneRequest& request, gpu::Device device)
    : device_(std::move(device)), request_(request), scene_(open_scene_at_once(request)) {
    start(std::move(scene_));
    path_ = document_path();
}

void Session::start(Scene scene) {
    scene.start.hash = state_hash(scene.document.state);
    const std::size_t undo_bytes = static_cast<std::size_t>(scene.view.whole("undo.memory_mib")) << 20U;
    auto simulation = std::make_unique<Simulation>(scene.document.state, scene.simulation, undo_bytes);
    auto renderer = std::make_unique<render::Renderer>(simulation->terrain(), patch_pixels(device_));
    if (!scene.tiles) drape(*renderer, scene);
    auto overflight = scene.tiles ? std::make_unique<Overflight>(
                                        scene.tiles, scene.view.whole("tiles.gpu_mib"), scene.draping.picture)
                                  : nullptr;
    const std::vector<float> ground = scene.document.state.ground();
    const auto [low, high] = std::minmax_element(ground.begin(), ground.end());
    bounds_ = {*low, *high};
    if (scene.tiles) bounds_ = {scene.tiles->lowest_m, scene.tiles->highest_m};
    scene_ = std::move(scene);
    ++terrain_number_;
    simulation_ = std::move(simulation);
    renderer_ = std::move(renderer);
    overflight_ = std::move(overflight);
    follow_surroundings();
    wave_note_ = app::wave_note(scene_.document.state, simulation_->parameters());
    gauges_ = Gauges(grid());
    sections_ = Sections();
    path_draft_ = PathDraft();
    legend_scale_.forget();
    spring_heights_ = SpringHeights();
    balances_.clear();
    saved_operations_.clear();
    recovered_ = false;
    compared_revision_.reset();
    activity_.forget();
    playing = false;
    sculpting_.forget();
    in_place_ = false;
    simulated_terrain_ = simulation_->terrain_number();
    forget_rectangle();
    suggest_for_terrain();
    frame_terrain();
    take_up_workspace();
    saved_placed_ = placed();
}

void Session::take_up_workspace() {
    const Workspace& kept = scene_.workspace;
    if (kept.camera) camera_ = *kept.camera;
    cameras_ = kept.cameras;
    path_draft_.take_up(kept.path_m);
    // What cannot be taken up is told, and takes nothing else with it.
    const auto attempt = [&](const char* what, auto take_up) {
        try {
            take_up();
        } catch (const Error& error) {
            message_ = fmt::format("{}{} are not as they were saved: {}", message_ ? *message_ + "; " : "",
                                   what, error.what());
        }
    };
    attempt("gauges", [&] { gauges_ = Gauges(grid(), kept.gauges, kept.gauge_times_s); });
    attempt("sections", [&] { sections_ = Sections(*simulation_, kept.sections, kept.section_times_s); });
}

Workspace Session::workspace() {
    // The count of sections begins anew where the project is opened: its last row must be of the end.
    if (!gauges_.all().empty()) gauges_.record(simulation_->terrain(), simulation_->clock().simulated_s);
    if (!sections_.all().empty()) sections_.record(*simulation_);
    Workspace kept;
    kept.parameters = kept_assignments(scene_.view);
    kept.camera = camera_;
    kept.cameras = cameras_;
    kept.gauges = gauges_.all();
    kept.gauge_times_s = gauges_.times_s();
    kept.sections = sections_.all();
    kept.section_times_s = sections_.times_s();
    kept.path_m = placed().path_m;
    return kept;
}

Placed Session::placed() const {
    Placed now;
    for (const Gauge& gauge : gauges_.all()) now.gauges_m.push_back(gauge.place_m);
    for (const PlacedSection& one : sections_.all()) now.sections.push_back(one.section);
    // One that is built is in the ground.
    if (!path_draft_.is_in_ground(*simulation_)) now.path_m = path_draft_.points_m();
    now.cameras = cameras_;
    return now;
}

void Session::keep_camera(const std::string& name) {
    if (name.empty()) throw Error("a camera that is kept needs a name");
    const auto same = [&](const NamedCamera& one) { return one.name == name; };
    const auto found = std::find_if(cameras_.begin(), cameras_.end(), same);
    if (found != cameras_.end())
        found->camera = camera_;
    else
        cameras_.push_back({name, camera_});
}

void Session::forget_camera(const std::string& name) {
    std::erase_if(cameras_, [&](const NamedCamera& one) { return one.name == name; });
}

void Session::go_to_camera(const std::string& name) {
    const render::Camera& wanted = camera_named(cameras_, name);
    if (wanted.fov_deg != scene_.view.number("camera.fov_deg"))
        scene_.view.set("camera.fov_deg", wanted.fov_deg);
    const bool from_top = scene_.view.choice("camera.mode") == "top";
    if (wanted.is_parallel() != from_top)
        scene_.view.set("camera.mode", std::string(wanted.is_parallel() ? "top" : "orbit"));
    camera_ = wanted;
}

std::optional<TiledRequest> Session::unready() const {
    return overflight_ || scene_.view.toggle("tiles.backdrop") ? scene_.unready : std::nullopt;
}

std::vector<std::string> Session::take_tiles(TiledTerrain terrain) {
    std::vector<std::string> notes = terrain.notes;
    const bool is_ready = terrain.is_measured;
    if (overflight_) {
        const auto tiles = std::make_shared<const TiledTerrain>(std::move(terrain));
        overflight_ =
            std::make_unique<Overflight>(tiles, scene_.view.whole("tiles.gpu_mib"), scene_.draping.picture);
        bounds_ = {tiles->lowest_m, tiles->highest_m};
        scene_.tiles = tiles;
        follow_photo();
    } else {
        notes = take_whole(scene_, std::move(terrain));
        follow_surroundings();
    }
    if (is_ready) scene_.unready.reset();
    std::vector<std::string>& told = scene_.document.notes;
    std::erase_if(notes, [&](const std::string& note) {
        return std::find(told.begin(), told.end(), note) != told.end();
    });
    told.insert(told.end(), notes.begin(), notes.end());
    return notes;
}

// Of the terrain as it is now: it may have been cropped, turned or resampled, or none of that any more.
void Session::follow_surroundings() {
    renderer_->stand_before(nullptr);
    surroundings_.reset();
    if (!scene_.view.toggle("tiles.backdrop")) return follow_photo();
    try {
        make_surroundings();
    } catch (const std::exception& error) {
        // The scene is there without them.
        surroundings_.reset();
        message_ = fmt::format("what stands around is not shown: {}", error.what());
    }
    follow_photo();
}

void Session::make_surroundings() {
    surroundings_ =
        surroundings_of(scene_, simulation_->terrain().grid(), simulation_->moment_state().georeference);
    if (surroundings_) renderer_->stand_before(&surroundings_->backdrop());
}

// Where on Earth what is looked at lies.
std::optional<Georeference> Session::georeference() const {
    return overflight_ ? overflight_->terrain().file.georeference()
                       : simulation_->moment_state().georeference;
}

// Of what is seen under it.
HeightsBetween Session::heights_under_photo() const {
    if (!scene_.draping.photo) return {};
    if (overflight_) return heights_between(overflight_->terrain().tree, overflight_->terrain().bounds);
    if (surroundings_) return surroundings_->heights();
    return heights_between(grid(), simulation_->terrain().ground.read_all<float>());
}

bool Session::shows_photo() const {
    return photo_ && render::view_named(scene_.view.choice("render.view")).natural;
}

// Over the terrain as it is now.
void Session::follow_photo() {
    photo_.reset();
    try {
        if (scene_.draping.photo && scene_.draping.photo->is_placed() && !georeference())
            throw Error("the terrain does not say any more where it lies");
        photo_ = photo_over(scene_.draping, grid(), georeference(), heights_under_photo(), scene_.view);
        if (photo_ && surroundings_) {
            const TiledTerrain& whole = surroundings_->tiles().terrain();
            photo_->stand_within(whole.tree.grid(), whole.file.georeference());
        }
    } catch (const std::exception& error) {
        message_ = fmt::format("{}{}the photo is not shown: {}", message_.value_or(""), message_ ? "; " : "",
                               error.what());
    }
    lay_photo();
}

void Session::lay_photo() {
    const render::LaidPhoto laid = photo_ ? photo_->laid() : render::LaidPhoto();
    if (overflight_) overflight_->lay(laid);
    renderer_->lay(laid);
    if (surroundings_) surroundings_->backdrop().lay(photo_ ? photo_->laid_around() : laid);
}

// Sizes and edges that were set for another terrain do not hold for this one.
void Session::forget_rectangle() {
    for (const char* name : {"map.nx", "map.ny", "map.west_m", "map.south_m", "map.east_m", "map.north_m"})
        scene_.view.reset(name);
}

void Session::suggest_for_terrain() {
    suggest_sizes(scene_.view, grid(), bounds_, overflight_ != nullptr);
    scene_.view.suggest("render.level_m", simulation_->parameters().number("water.sea_level_m"));
    suggest_for_stamp();
}

void Session::suggest_for_stamp() {
    if (const Stamp* stamp = simulation_->stamp().get())
        scene_.view.suggest("stamp.relief_m",
                            natural_relief_m(*stamp, 2 * scene_.view.number("brush.radius_m")));
}

void Session::follow_terrain() {
    if (simulated_terrain_ == simulation_->terrain_number()) return;
    simulated_terrain_ = simulation_->terrain_number();
    ++terrain_number_;
    const glm::dvec2 extent_before(scene_.document.state.grid.width_m(),
                                   scene_.document.state.grid.height_m());
    renderer_ = std::make_unique<render::Renderer>(simulation_->terrain(), patch_pixels(device_));
    const std::vector<float> ground = simulation_->terrain().ground.read_all<float>();
    const auto [low, high] = std::minmax_element(ground.begin(), ground.end());
    bounds_ = {*low, *high};
    scene_.document.state.grid = grid();
    // A picture over the terrain before is not one over this; a photo lies where it does.
    scene_.draping.picture = {};
    if (scene_.draping.photo && !scene_.draping.photo->is_placed()) scene_.draping.photo.reset();
    follow_surroundings();
    gauges_ = Gauges(grid());
    sections_ = Sections();
    path_draft_ = PathDraft();
    legend_scale_.forget();
    spring_heights_ = SpringHeights();
    balances_.clear();
    activity_.forget();
    forget_rectangle();
    suggest_for_terrain();
    if (extent_before != glm::dvec2(grid().width_m(), grid().height_m())) frame_terrain();
}

void Session::frame_terrain() {
    camera_ = first_look(scene_.view, grid(), bounds_, picture_aspect);
    if (camera_.is_parallel() && surroundings_)
        render::keep_over(camera_, grid(), surroundings_->backdrop().range_m().y);
}

render::Drawn Session::draw(const render::ViewSettings& settings, glm::ivec2 size, const render::Ring& ring) {
    if (shows_photo()) photo_->follow(camera_, size);
    lay_photo();
    if (overflight_) return overflight_->draw(camera_, settings, size);
    if (surroundings_) surroundings_->follow(camera_, size, settings.tolerance_px);
    return renderer_->draw(simulation_->terrain(), camera_, settings, size.x, size.y, ring);
}

bool Session::refine() {
    const int samples = scene_.view.whole("render.samples");
    return overflight_ ? overflight_->refine(samples) : renderer_->refine(simulation_->terrain(), samples);
}

const gpu::Framebuffer& Session::framebuffer() const {
    if (outlined_) return outline_.framebuffer();
    return overflight_ ? overflight_->renderer().framebuffer() : renderer_->framebuffer();
}

const gpu::Texture& Session::hits() const {
    return overflight_ ? overflight_->renderer().hits() : renderer_->hits();
}

std::vector<render::Legend> Session::legends(const render::ViewSettings& settings) const {
    if (overflight_) return render::tiled_legend_of(settings, overflight_->surface());
    // Colours go by what stands around too.
    const glm::dvec2 bounds = surroundings_ ? surroundings_->backdrop().range_m() : renderer_->bounds();
    return render::legend_of(settings, bounds.x, bounds.y);
}

void Session::forget_picture() {
    renderer_->forget();
    if (overflight_) overflight_->forget();
}

Still Session::still(glm::ivec2 size) {
    // Of what is there now, though the window has not yet looked.
    if (!overflight_ && !playing && !stroking() && !mid_tick())
        suggest_scale_end(scene_.view, simulation_->parameters(), simulation_->terrain());
    const render::ViewSettings settings = render::view_settings(scene_.view, simulation_->parameters());
    if (overflight_) render::check_view_of_tiles(settings);
    StillPainter painter = overflight_ ? overflight_->painter(settings)
                           : surroundings_
                               ? surroundings_->painter(*renderer_, simulation_->terrain(), settings)
                               : painter_of(*renderer_, simulation_->terrain(), settings);
    lay_photo();
    if (photo_) painter = with_photo(painter, *photo_, settings.view, Missing::coarser);
    Still still = draw_still(painter, camera_, legends(settings), size, scene_.view.whole("render.samples"));
    forget_picture();
    return still;
}

std::optional<GroundSamples> Session::ground_samples(glm::dvec2 place_m) const {
    if (overflight_) return ground_samples_of(overflight_->surface(), place_m);
    const auto inside = ground_samples_of(simulation_->terrain(), place_m);
    if (inside || !surroundings_) return inside;
    const glm::dvec3 over = surroundings_->backdrop().camera_over_tiles({{place_m, 0}, {place_m, 1}}).eye;
    return ground_samples_of(surroundings_->tiles().surface(), {over.x, over.y});
}

void Session::follow_height(std::optional<double> ground_m) {
    if (!tiles()) return;
    // The ground below passes by as fast wherever the camera flies.
    constexpr double heights_per_s = 1.5;
    constexpr double slowest_m_per_s = 5;
    const double height_m = camera_.eye.z - ground_m.value_or(bounds_.x);
    scene_.view.suggest(
        "camera.speed_m_per_s",
        std::clamp(heights_per_s * height_m, slowest_m_per_s,
                   std::max(slowest_m_per_s, std::max(grid().width_m(), grid().height_m()) / 12)));
}

void Session::check_editable() const {
    if (!overflight_) return;
    throw Error(
        fmt::format("'{}' is shown in tiles: it can be looked at, and not changed or written", scene_.title));
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
    request.assignments = wish.assignments;
    request.tiled = wish.tiled;
    request.in_place = wish.in_place;
    request.title = wish.title;
    // An image over one terrain is not one over another, nor over a part of it; a photo lies where it does.
    const bool lies_there = wish.in_place && scene_.draping.photo && scene_.draping.photo->is_placed();
    if (lies_there) return request;
    if (wish.input != request_.input || wish.import.window != request_.import.window) request.texture.clear();
    return request;
}

void Session::open(const SceneRequest& request, Scene scene) {
    const std::optional<Outlook> before = outlook_of(*this);
    start(std::move(scene));
    request_ = request;
    path_ = document_path();
    // Who cuts a part out, or goes back to the whole, sees what he saw; so does who opens a mosaic over it.
    in_place_ = before && tiles() && (request.in_place || is_over(*this, *before));
    if (in_place_) look_as(*this, *before);
}

void Session::outline_part(bool shown, glm::ivec2 size) {
    outlined_ = shown && tiles();
    if (!outlined_) return;
    const Rectangle edges =
        overflight_ ? part_of(scene_.view) : Rectangle{0, 0, grid().width_m(), grid().height_m()};
    const gpu::Texture& colours = overflight_ ? overflight_->renderer().colours() : renderer_->colours();
    const double margin = 0.01 * std::min(grid().dx, grid().dy);
    const Rectangle all = ground_edges();
    const Rectangle ground{all.west_m + margin, all.south_m + margin, all.east_m - margin,
                           all.north_m - margin};
    outline_.draw(colours, hits(), grid(), camera_, size, edges, ground);
}

Rectangle Session::ground_edges() const {
    if (!surroundings_) return {0, 0, grid().width_m(), grid().height_m()};
    const Grid& whole = surroundings_->tiles().terrain().tree.grid();
    const glm::dvec3 corner = surroundings_->backdrop().camera_from_tiles({}).eye;
    return {corner.x, corner.y, corner.x + whole.width_m(), corner.y + whole.height_m()};
}

void Session::recovered(const std::string& project, const std::string& title) {
    path_ = project;
    scene_.title = title;
    recovered_ = true;
    // A reset must not open the autosave in the recovery folder again.
    request_.input = project;
}

bool Session::unsaved() const {
    if (recovered_ || placed() != saved_placed_) return true;
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
    start(open_scene_at_once(request_));
    path_ = document_path();
}

io::Document Session::document() {
    while (simulation_->mid_tick()) simulation_->advance(1 << 20);
    check_editable();
    scene_.document.state = simulation_->read();
    scene_.document.parameters = to_toml(simulation_->parameters());
    return scene_.document;
}

void Session::saved(const std::string& path, std::size_t revision_then) {
    // Other formats hold the ground alone: what was saved there is an export.
    if (io::ending_of(path) != ".exr") return;
    path_ = path;
    scene_.title = std::filesystem::path(path).filename().string();
    if (recovered_) request_.input = path;
    recovered_ = false;
    // What was done while it was written is not saved.
    if (revision_then == revision()) saved_operations_ = simulation_->journal().operations();
    saved_placed_ = placed();
    compared_revision_.reset();
}

void Session::write_journal_to(const std::string& path) const {
    check_editable();
    io::write_atomically(path, write_journal(scene_.start, simulation_->journal()));
}

bool Session::is_simulated(const std::string& name) const {
    const auto& declared = simulation_->parameters().declared();
    return std::any_of(declared.begin(), declared.end(), [&](const Parameter& p) { return p.name == name; });
}

void Session::set(const std::string& name, const Value& value) {
    if (is_simulated(name)) return set_simulated(name, value);
    if (overflight_ && name == "render.view") {
        render::ViewSettings wish;
        wish.view = std::get<std::string>(value);
        render::check_view_of_tiles(wish);
    }
    scene_.view.set(name, value);
    if (name == "brush.radius_m") suggest_for_stamp();
    follow_undo_memory();
    if (name == "tiles.backdrop") follow_surroundings();
}

void Session::unset(const std::string& name) {
    if (is_simulated(name)) return set_simulated(name, std::nullopt);
    scene_.view.reset(name);
    suggest_for_terrain();
    legend_scale_.unset(scene_.view, name);
    follow_undo_memory();
    if (name == "tiles.backdrop") follow_surroundings();
}

void Session::follow_undo_memory() {
    simulation_->set_undo_capacity(static_cast<std::size_t>(scene_.view.whole("undo.memory_mib")) << 20U);
}

void Session::set_simulated(const std::string& name, const std::optional<Value>& value) {
    check_editable();
    while (simulation_->mid_tick()) simulation_->advance(1 << 20);
    simulation_->apply(SetParameter{name, value});
    if (name.starts_with("water."))
        wave_note_ = app::wave_note(scene_.document.state, simulation_->parameters());
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
    run_ticks(wall_s, budget_s, false);
}

bool Session::end_tick(double budget_s) {
    if (!mid_tick()) return true;
    run_ticks(0, budget_s, true);
    if (mid_tick()) return false;
    if (!playing && !stroking()) simulation_->end_entry();
    return true;
}

void Session::run_ticks(double wall_s, double budget_s, bool ends) {
    const double simulated_before = simulation_->clock().simulated_s;
    if (const auto ms = tick_timer_.milliseconds()) ticks_.took(*ms, timed_);
    const bool timing = !tick_timer_.pending();
    if (timing) tick_timer_.begin();
    const TickPacing::Ran ran = ticks_.play(
        {[&](int substeps) { return simulation_->advance(substeps); },
         [&] { return simulation_->mid_tick(); }, [&] { return simulation_->substeps_sent(); }, wall_clock_s},
        {wall_s, budget_s, simulation_->parameters().number("time.tick_s"), scene_.view.number("time.speed"),
         stroking(), ends});
    if (timing) {
        timed_ = ran;
        if (ran.substeps > 0) tick_timer_.end();
    }
    if (wall_s > 0 && !ran.saved) {
        const double reached = (simulation_->clock().simulated_s - simulated_before) / wall_s;
        speed_reached_ += 0.1 * (reached - speed_reached_);
    }
}

void Session::pause() {
    playing = false;
    speed_reached_ = 0;
    ticks_.stop();
    while (simulation_->mid_tick()) simulation_->advance(1 << 20);
    if (!stroking()) simulation_->end_entry();
}

void Session::set_playing(bool plays) {
    check_editable();
    if (plays == playing) return;
    if (playing)
        pause();
    else
        playing = true;
}

void Session::step() {
    check_editable();
    pause();
    simulation_->apply(Ticks{1});
    simulation_->end_entry();
}

void Session::begin_step() {
    check_editable();
    pause();
    simulation_->advance(1);
    if (!mid_tick()) simulation_->end_entry();
}

void Session::give_up_run() {
    if (!mid_tick()) return;
    playing = false;
    speed_reached_ = 0;
    ticks_.stop();
    sculpting_.forget();
    simulation_->take_back_entry();
    follow_terrain();
}

void Session::let_go_of_stroke() {
    if (!simulation_->mid_tick()) end_stroke();
}

void Session::apply(const Operation& operation) {
    check_editable();
    end_stroke();
    pause();
    simulation_->apply(operation);
    simulation_->end_entry();
    if (std::holds_alternative<DriveParameter>(operation))
        wave_note_ = app::wave_note(scene_.document.state, simulation_->parameters());
    suggest_for_terrain();
    follow_terrain();
}

void Session::apply_together(const std::string& name, const std::vector<Operation>& operations) {
    check_editable();
    end_stroke();
    while (simulation_->mid_tick()) simulation_->advance(1 << 20);
    simulation_->begin_stroke(name);
    try {
        for (const Operation& one : operations) simulation_->apply(one);
    } catch (...) {
        simulation_->take_back_entry();
        throw;
    }
    simulation_->end_entry();
    suggest_for_terrain();
}

void Session::mask_rectangle(glm::dvec2 from_m, glm::dvec2 to_m, bool limits_erosion) {
    const glm::dvec2 low = glm::min(from_m, to_m);
    const glm::dvec2 high = glm::max(from_m, to_m);
    MakeMask make{MaskSource::rectangle};
    make.rectangle = {low.x, low.y, high.x, high.y};
    make.fade = std::min(high.x - low.x, high.y - low.y) / 20;
    // For erosion it is where water takes; else it is joined as the panel Mask says.
    if (!limits_erosion) {
        make.join = scene_.view.choice_as<MaskJoin>("mask.join");
        make.inverted = scene_.view.toggle("mask.inverted");
    }
    std::vector<Operation> operations = {make};
    if (limits_erosion && simulation_->parameters().choice("erosion.over") != "mask")
        operations.emplace_back(SetParameter{"erosion.over", Value(std::string("mask"))});
    apply_together("mask: rectangle", operations);
}

void Session::balance() {
    while (simulation_->mid_tick()) simulation_->advance(1 << 20);
    balances_.keep({simulation_->ledger(), simulation_->clock().simulated_s});
}

void Session::follow_gauges() {
    if (!overflight_) spring_heights_.follow(*simulation_);
    // Within a tick the water is at no time of the clock's.
    if (simulation_->mid_tick()) return;
    gauges_.follow(simulation_->terrain(), simulation_->clock().simulated_s);
    sections_.follow(*simulation_);
}

void Session::build_path() {
    check_editable();
    end_stroke();
    pause();
    // A key that is held asks again and again.
    if (path_draft_.is_built(*simulation_)) return;
    std::optional<Dab> dab = path_draft_.dab(*simulation_, scene_.view);
    if (!dab) throw Error("a path needs two points or more: click on the ground where it goes along");
    dab->masked = scene_.view.choice("brush.over") == "mask";
    apply(*dab);
    path_draft_.set_built(*simulation_);
}

void Session::place_section(glm::dvec3 from, glm::dvec3 to) {
    check_editable();
    sections_.place(*simulation_, {from, to}, {from.z, to.z});
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

}  // namespace talus::app

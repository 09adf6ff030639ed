#pragma once
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/core/activity.h"
#include "app/core/balances.h"
#include "app/core/gauges.h"
#include "app/core/ground_samples.h"
#include "app/core/legend_scale.h"
#include "app/core/overflight.h"
#include "app/core/paged_photo.h"
#include "app/core/path_draft.h"
#include "app/core/placed.h"
#include "app/core/scene.h"
#include "app/core/sculpting.h"
#include "app/core/sections.h"
#include "app/core/springs.h"
#include "app/core/surroundings.h"
#include "app/core/tick_pacing.h"
#include "render/outline.h"
#include "render/renderer.h"
#include "sim/gpu/context.h"
#include "sim/gpu/timestamp.h"
#include "sim/simulation.h"

namespace talus::app {

/// What the window works on: a scene, its simulation and its picture. Knows no window and no panel.
class Session {
  public:
    /// Throws talus::Error when the scene cannot be made.
    Session(const SceneRequest& request, gpu::Device device);

    Simulation& simulation() { return *simulation_; }
    const Simulation& simulation() const { return *simulation_; }
    render::Renderer& renderer() { return *renderer_; }
    /// The terrain in tiles that is looked at instead of the simulation's. Null: the simulation's terrain is.
    const Overflight* overflight() const { return overflight_.get(); }
    /// What stands around the terrain in pictures; null: nothing.
    const Surroundings* surroundings() const { return surroundings_.get(); }
    /// The tiles that pictures are made of, around the terrain or in its place; null: none.
    const PagedTiles* tiles() const {
        return overflight_ ? &overflight_->tiles() : surroundings_ ? &surroundings_->tiles() : nullptr;
    }
    /// The photo over the terrain, in tiles; null: none, or the view does not show it.
    const PagedPhoto* photo() const { return shows_photo() ? photo_.get() : nullptr; }
    /// Parameters of drawing and of the hand: not recorded.
    Parameters& view() { return scene_.view; }
    const Parameters& view() const { return scene_.view; }
    const Scene& scene() const { return scene_; }
    const SceneRequest& request() const { return request_; }
    /// Tiles that are to be made ready (open_tiled()) before they are shown in place of a sketch, or around
    /// the terrain. None: there are none, or `tiles.backdrop` asks for none around it.
    std::optional<TiledRequest> unready() const;
    /// Shows them, ready or a better sketch of them. The camera stays. Returns notes of theirs that were not
    /// told before. Throws talus::Error where they cannot be shown.
    std::vector<std::string> take_tiles(TiledTerrain terrain);
    render::Camera& camera() { return camera_; }
    /// Cameras to go back to.
    const std::vector<NamedCamera>& cameras() const { return cameras_; }
    /// The present one by a name; one of the same name goes. Throws talus::Error where the name is empty.
    void keep_camera(const std::string& name);
    void forget_camera(const std::string& name);
    /// Throws talus::Error where there is none of the name.
    void go_to_camera(const std::string& name);
    /// Another number for every terrain that was opened or reset, or took the place of the one before.
    int terrain_number() const { return terrain_number_; }
    /// Of what is looked at.
    const Grid& grid() const {
        return overflight_ ? overflight_->terrain().tree.grid() : simulation_->terrain().grid();
    }
    /// Heights at the last open or reset, for the camera and for legends.
    glm::dvec2 bounds() const { return bounds_; }

    /// The lowest and the highest that stands there now, as of one of the last pictures.
    glm::dvec2 heights_m() const { return overflight_ ? bounds_ : renderer_->bounds(); }
    /// Where on Earth it lies; none: nobody said.
    std::optional<Georeference> georeference() const;

    /// What is to be said of the wave maker's truth to nature (app/core/wave_note.h), of the ground that was
    /// opened.
    const std::string& wave_note() const { return wave_note_; }

    /// Draws what is looked at.
    render::Drawn draw(const render::ViewSettings& settings, glm::ivec2 size, const render::Ring& ring);
    /// Adds a sample per pixel to the picture drawn last, as far as `render.samples` asks for. False: it has
    /// them.
    bool refine();
    /// What draw() and refine() made, and the hits of its rays.
    const gpu::Framebuffer& framebuffer() const;
    const gpu::Texture& hits() const;
    std::vector<render::Legend> legends(const render::ViewSettings& settings) const;
    /// Where the scale of the view follows what is there, it does. Once a frame, before draw().
    void follow_scale() {
        if (!overflight_)
            legend_scale_.follow(scene_.view, *simulation_, playing || stroking() || mid_tick());
    }
    /// True while the device is at what a scale, or a sign, needs.
    bool awaits_readbacks() const {
        return !overflight_ && (legend_scale_.pending() || spring_heights_.pending() || gauges_.pending());
    }
    /// After draw() and refine(), for a picture of that size: lays over it the outline of the part that is
    /// chosen (app/core/part.h), or of the scene before what stands around it.
    void outline_part(bool shown, glm::ivec2 size);
    /// Whether the camera is where it is to be since the scene was opened: where it was, over a part of what
    /// was looked at or the whole around it, or where the project kept it.
    bool keeps_camera() const { return in_place_ || scene_.workspace.camera; }
    /// The next picture is drawn anew.
    void forget_picture();
    /// A picture of this size for a file.
    Still still(glm::ivec2 size);
    /// Samples of the ground around a place, on the device; none beside the terrain.
    std::optional<GroundSamples> ground_samples(glm::dvec2 place_m) const;
    /// Where there is ground, around the terrain too: edges in the terrain's metres.
    Rectangle ground_edges() const;
    /// In tiles the camera's speed follows its height, unless somebody set it. ground_m: below the eye; none:
    /// not known.
    void follow_height(std::optional<double> ground_m);
    /// True while tiles are read that a frame may show.
    bool awaits_tiles() const {
        return (tiles() && tiles()->awaits_tiles()) || (shows_photo() && photo_->awaits_tiles());
    }
    /// True while some have come for a frame.
    bool has_tiles() const {
        return (tiles() && tiles()->has_news()) || (shows_photo() && photo_->has_news());
    }
    /// Throws talus::Error where the terrain is in tiles: it can be looked at, and not changed or written.
    void check_editable() const;

    bool playing = false;
    /// Simulates for `wall_s` of wall time with `budget_s` of work (seconds), on average: for a longer
    /// sub-step the budget is saved up over several calls. Measures the speed reached. While a stroke waits
    /// for the end of a tick, no other tick begins.
    void play(double wall_s, double budget_s);
    double speed_reached() const { return speed_reached_; }
    double tick_ms() const { return ticks_.tick_ms(); }
    /// Completes a tick that is half done.
    void pause();
    /// Plays, or pauses.
    void set_playing(bool plays);
    /// One tick. Waits until it is sent.
    void step();
    /// Begins one; the window ends it by end_tick(), frame by frame.
    void begin_step();
    bool mid_tick() const { return simulation_->mid_tick(); }
    /// Goes on with the tick that is half done, with `budget_s` of work as play(); no other begins. True
    /// where none is half done any more.
    bool end_tick(double budget_s);
    /// Leaves the tick that is half done and takes the run, or the stroke, back that it is of; it cannot be
    /// redone.
    void give_up_run();

    /// The request for another scene: `wish` completed by options that this session was started with.
    SceneRequest request_for(const SceneRequest& wish) const;
    /// Opens a scene that was made from the request. If that fails, the present scene stays.
    void open(const SceneRequest& request, Scene scene);
    /// The scene came from an autosave of this project (empty: none yet): it is unsaved, and saved there.
    void recovered(const std::string& project, const std::string& title);
    void reset();
    double picture_aspect = 16.0 / 9;  ///< width by height of the picture that the terrain is framed in
    void frame_terrain();
    /// What is to be saved, as it is now, without the workspace. Waits for the device.
    io::Document document();
    /// What is to be kept besides, as it is now, but for the panels. Between ticks; where there are gauges or
    /// sections without a row of now, it waits for the device.
    Workspace workspace();
    Placed placed() const;
    /// It was written there, as it was at this revision: what was done since is not saved.
    void saved(const std::string& path, std::size_t revision);
    /// The document that save goes to; empty where a heightmap was opened or nothing was saved yet.
    const std::string& path() const { return path_; }
    /// Whether anything was done or placed since it was opened or saved, and not taken back.
    bool unsaved() const;
    /// Rises with everything that is done.
    std::size_t revision() const { return simulation_->journal().revision(); }
    void write_journal_to(const std::string& path) const;

    /// Sets any parameter by name: simulation parameters as recorded operations, the others at once.
    void set(const std::string& name, const Value& value);
    /// As if nobody had ever set it: its default, or what it follows.
    void unset(const std::string& name);
    const Value& value(const std::string& name) const;
    /// Whether a preset, a person or a file set it.
    bool is_given(const std::string& name) const;
    const Parameter& declaration(const std::string& name) const;
    /// Whether it is one of the simulation's; the others are of drawing and of the hand.
    bool is_simulated(const std::string& name) const;

    void begin_stroke(glm::dvec3 at, const Modifiers& modifiers = {}) {
        check_editable();
        sculpting_.begin(scene_.view, at, modifiers);
    }
    /// The hand is at a place on the ground after this much wall time.
    void stroke(glm::dvec3 at, double wall_s) { sculpting_.move(*simulation_, scene_.view, at, wall_s); }
    void end_stroke() { sculpting_.end(*simulation_, scene_.view); }
    /// The same once the tick that goes on has ended: the stroke goes on until then.
    void let_go_of_stroke();
    bool stroking() const { return sculpting_.stroke().has_value(); }
    const Sculpting& sculpting() const { return sculpting_; }
    /// What the brush shows of itself there.
    render::Ring ring(glm::dvec2 at_m) { return sculpting_.ring(*simulation_, scene_.view, at_m); }

    /// An act of its own: ends what is open, pauses, and does it. Throws talus::Error, with nothing changed,
    /// when it cannot be done.
    void apply(const Operation& operation);

    /// The rectangle between two places on the ground becomes the mask, its edges fading over a twentieth of
    /// its shorter side. `limits_erosion`: water and slopes act in it alone from then on; else it is joined
    /// as `mask.join` and `mask.inverted` say.
    void mask_rectangle(glm::dvec2 from_m, glm::dvec2 to_m, bool limits_erosion);
    /// Several as one act of this name; play goes on. Throws talus::Error, with nothing changed, when one
    /// cannot be done; if that is not the first, nothing can be redone then.
    void apply_together(const std::string& name, const std::vector<Operation>& operations);

    void undo();
    void redo();
    /// Undoes or redoes until so many acts are done.
    void go_to(std::size_t done);
    /// What goes on behind the acts' back. Once a loop of the window, drawn or not.
    void poll() { simulation_->poll_undo(); }
    /// What is to be told that nobody asked for, once.
    std::optional<std::string> take_message() {
        if (message_) return std::exchange(message_, std::nullopt);
        std::optional<std::string> told = overflight_     ? overflight_->tiles().take_message()
                                          : surroundings_ ? surroundings_->tiles().take_message()
                                                          : std::nullopt;
        return told || !photo_ ? told : photo_->take_message();
    }

    /// Reads the ledger now. Waits for the device: an act, not part of a frame.
    void balance();
    const std::vector<Balance>& balances() const { return balances_.all(); }
    void follow_ledger() { balances_.follow(*simulation_); }

    const Activity::Counts& activity() const { return activity_.counts(); }
    void follow_activity() { activity_.follow(simulation_->terrain().tiles); }

    /// A path that is being drawn.
    PathDraft& path_draft() { return path_draft_; }
    const PathDraft& path_draft() const { return path_draft_; }
    /// Builds it, as an act of its own, by the mask where brushes act by it. Throws talus::Error where it has
    /// less than two points.
    void build_path();
    /// Designs it anew where it, or the ground, has changed; while the ground moves, for the ground before.
    /// Once a frame.
    void follow_path() {
        if (!overflight_)
            path_draft_.follow(*simulation_, scene_.view,
                               !playing && !stroking() && !simulation_->mid_tick());
    }

    Gauges& gauges() { return gauges_; }
    const Gauges& gauges() const { return gauges_; }
    const render::Camera& camera() const { return camera_; }
    const Sections& sections() const { return sections_; }
    /// A line between two places on the ground. Throws talus::Error where it cannot be one.
    void place_section(glm::dvec3 from, glm::dvec3 to);
    void remove_section(std::size_t index) { sections_.remove(*simulation_, index); }
    /// The ground at the springs, for their signs.
    const SpringHeights& spring_heights() const { return spring_heights_; }
    /// Takes what gauges, sections and springs show, without waiting. Once a frame.
    void follow_gauges();

  private:
    void run_ticks(double wall_s, double budget_s, bool ends);
    void start(Scene scene);
    /// Takes up what the project keeps besides its terrain.
    void take_up_workspace();
    /// Makes anew what hangs on the terrain's size, where another one took its place.
    void follow_terrain();
    void follow_surroundings();
    void follow_photo();
    HeightsBetween heights_under_photo() const;
    bool shows_photo() const;
    void lay_photo();
    void make_surroundings();
    void suggest_for_terrain();
    void suggest_for_stamp();
    void forget_rectangle();
    void follow_undo_memory();
    void set_simulated(const std::string& name, const std::optional<Value>& value);
    std::string document_path() const;

    gpu::Device device_;
    SceneRequest request_;
    Scene scene_;
    std::unique_ptr<Simulation> simulation_;
    std::unique_ptr<render::Renderer> renderer_;
    std::unique_ptr<Overflight> overflight_;
    std::unique_ptr<Surroundings> surroundings_;
    std::unique_ptr<PagedPhoto> photo_;
    render::Camera camera_;
    std::vector<NamedCamera> cameras_;
    int terrain_number_ = 0;
    glm::dvec2 bounds_{0};
    Balances balances_;
    Activity activity_;
    Gauges gauges_{Grid()};
    Sections sections_;
    SpringHeights spring_heights_;
    PathDraft path_draft_;
    LegendScale legend_scale_;
    std::string wave_note_;
    std::string path_;
    std::vector<Operation> saved_operations_;
    Placed saved_placed_;
    bool recovered_ = false;
    mutable std::optional<std::size_t> compared_revision_;  // at which unsaved_ was found
    mutable bool unsaved_ = false;
    Sculpting sculpting_;
    TickPacing ticks_;
    gpu::Timestamp tick_timer_{"ticks"};
    TickPacing::Ran timed_;  // what the timer is of
    double speed_reached_ = 0;
    bool in_place_ = false;
    std::optional<std::string> message_;
    render::Outline outline_;
    bool outlined_ = false;
    int simulated_terrain_ = 0;  // the simulation's number of it
};

}  // namespace talus::app

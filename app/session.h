#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/gauges.h"
#include "app/scene.h"
#include "render/renderer.h"
#include "sim/gpu/context.h"
#include "sim/gpu/timestamp.h"
#include "sim/simulation.h"

namespace talus {

/// What the window works on: a scene, its simulation and its picture. Knows no window and no panel.
class Session {
  public:
    /// Throws talus::Error when the scene cannot be made.
    Session(const SceneRequest& request, gpu::Device device);

    Simulation& simulation() { return *simulation_; }
    const Simulation& simulation() const { return *simulation_; }
    Renderer& renderer() { return *renderer_; }
    /// Parameters of drawing and of the hand: not recorded.
    Parameters& view() { return scene_.view; }
    const Scene& scene() const { return scene_; }
    const SceneRequest& request() const { return request_; }
    Camera& camera() { return camera_; }
    /// Another number for every terrain that was opened or reset.
    int terrain_number() const { return terrain_number_; }
    const Grid& grid() const { return simulation_->terrain().grid(); }
    /// Heights at the last open or reset, for the camera and for legends.
    glm::dvec2 bounds() const { return bounds_; }

    /// What is to be said of the wave maker's truth to nature (app/wave_note.h), of the ground that was
    /// opened.
    const std::string& wave_note() const { return wave_note_; }

    bool playing = false;
    /// Plays for this much wall time within this much work (seconds); measures the speed reached.
    void play(double wall_s, double budget_s);
    double speed_reached() const { return speed_reached_; }
    double tick_ms() const { return tick_ms_; }
    void pause();
    void toggle_play();
    void step();

    /// Another file, or the same scene from its start: what was here before stays where that fails.
    void open(const std::string& path, const ImportSettings& import = {});
    void reset();
    void frame_terrain();
    /// Writes the document or heightmap by the path's ending; the document's path becomes the session's.
    void save(const std::string& path);
    /// The document that save goes to; empty where a heightmap was opened or nothing was saved yet.
    const std::string& path() const { return path_; }
    bool unsaved() const { return simulation_->journal().operations() != saved_operations_; }
    void write_journal_to(const std::string& path) const;

    /// Sets any parameter by name: simulation parameters as recorded operations, the others at once.
    void set(const std::string& name, const Value& value);
    const Value& value(const std::string& name) const;
    const Parameter& declaration(const std::string& name) const;

    void begin_stroke(glm::dvec3 at);
    /// A dab of this much wall time at a place on the ground.
    void stroke(glm::dvec3 at, double wall_s);
    void end_stroke();
    bool stroking() const { return stroking_; }

    void undo();
    void redo();

    /// Reads the ledger now. Waits for the device: an act, not part of a frame.
    void balance();
    /// Readings of the ledger and when they were, oldest first: the last few hundred.
    struct Balance {
        LedgerReading ledger;
        double simulated_s = 0;
    };
    const std::vector<Balance>& balances() const { return balances_; }
    /// Takes what the ledger shows, without waiting, and asks anew about twice a second. Once a frame, while
    /// somebody looks at it.
    void follow_ledger();

    Gauges& gauges() { return gauges_; }
    const Gauges& gauges() const { return gauges_; }
    const Camera& camera() const { return camera_; }
    /// Takes what gauges show, without waiting. Once a frame.
    void follow_gauges();

  private:
    void start(Scene scene);
    std::string document_path() const;
    bool is_simulated(const std::string& name) const;

    gpu::Device device_;
    SceneRequest request_;
    Scene scene_;
    std::unique_ptr<Simulation> simulation_;
    std::unique_ptr<Renderer> renderer_;
    Camera camera_;
    int terrain_number_ = 0;
    glm::dvec2 bounds_{0};
    void keep_balance(const LedgerReading& ledger, double simulated_s);
    std::vector<Balance> balances_;
    double ledger_asked_at_s_ = 0;  // of the clock on the wall, and of the simulation
    double ledger_of_s_ = 0;
    std::uint64_t ledger_of_changes_ = 0;
    Gauges gauges_{Grid()};
    std::string wave_note_;
    std::string path_;
    std::vector<Operation> saved_operations_;
    double owed_s_ = 0;
    double speed_reached_ = 0;
    double tick_ms_ = 0;
    gpu::Timestamp tick_timer_{"ticks"};
    int timed_ticks_ = 0;
    double substep_ms_ = 0;
    std::uint64_t timed_substeps_ = 0;
    bool stroking_ = false;
    double stroke_height_m_ = 0;
    glm::dvec3 stroke_at_{0};
};

}  // namespace talus

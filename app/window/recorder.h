#pragma once
#include <future>
#include <memory>
#include <optional>
#include <string>

#include "app/core/live_film.h"
#include "app/core/session.h"
#include "sim/gpu/readback.h"
#include "sim/gpu/region.h"

namespace talus::app {

/// Records what the window shows between its panels, as a film beside the project.
class Recorder {
  public:
    ~Recorder();

    bool is_on() const { return film_ != nullptr; }
    /// Begins a film of this size; one that goes on ends. Throws talus::Error where it cannot begin, or the
    /// one before is still being written.
    void toggle(const Session& session, glm::ivec2 size);
    /// After a picture was drawn into the window, before anything over it: `region` of it, rows from below.
    void follow(const Session& session, const render::ViewSettings& settings, const gpu::Region& region);
    /// How long it is, and what it costs a frame; empty: none is recorded.
    std::string state() const;
    /// What is to be told of films that ended, once. Does not wait.
    std::optional<std::string> take_message();
    /// Ends a film that goes on, and waits until all are written.
    void finish();

  private:
    void end();
    void show(const std::vector<float>& words);

    std::string path_;
    std::unique_ptr<LiveFilm> film_;
    gpu::Readback pixels_;
    glm::ivec2 pixels_size_{1};
    std::vector<render::Legend> legends_;  // of that picture
    double asked_s_ = 0;                   // when they were what the window showed
    double cost_ms_ = 0;                   // of a frame, lately
    std::future<std::string> ending_;
    std::optional<std::string> message_;
};

}  // namespace talus::app

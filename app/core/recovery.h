#pragma once
#include <filesystem>
#include <functional>
#include <future>
#include <optional>
#include <string>
#include <vector>

#include "app/core/placed.h"
#include "app/core/scene.h"
#include "sim/terrain/state_readback.h"

namespace talus::app {
class Session;

/// What a session that ended without saving left behind.
struct LeftBehind {
    std::filesystem::path folder;
    std::filesystem::path document;  ///< its last autosave
    std::string title;
    std::string project;  ///< the document it was saved to; empty: none yet
    std::string saved_at;
};

/// Sessions that are not alive any more and left unsaved work, newest first. Empty folders of dead sessions
/// go.
std::vector<LeftBehind> left_behind();
/// It was recovered and saved, or is not wanted.
void forget(const LeftBehind& left);

/// Keeps a session's unsaved work on disk, so that a crash costs as much as was done since the last autosave.
/// A session has a folder of its own, with a lock that the system lets go when the process ends, however it
/// ends.
class Recovery {
  public:
    /// Without a folder where none can be made: then nothing is kept, and why() says so.
    Recovery();
    /// Lets go of the lock: what was kept stays, unless end() was called.
    ~Recovery();
    Recovery(const Recovery&) = delete;
    Recovery& operator=(const Recovery&) = delete;
    const std::string& why() const { return why_; }

    /// Call once per loop of the window. Where something is unsaved, begins an autosave `interval_s` after
    /// the last one. The read-back of layers does not wait, and a background task writes the file.
    /// `workspace`: what the document keeps of it, asked for when an autosave begins; it waits where gauges
    /// or sections are to be read.
    void follow(const Session& session, const std::function<Workspace()>& workspace, double interval_s);
    /// The work was saved, or dropped: what was kept of it is of no use any more.
    void forget_work();
    /// An orderly end: nothing is left behind.
    void end();
    /// The error of an autosave that failed since the last call; none: no autosave failed.
    std::optional<std::string> take_message();
    bool busy() const { return readback_.pending() || writing_.valid(); }

  private:
    std::filesystem::path folder_;
    int lock_ = -1;
    std::string why_;
    StateReadback readback_;
    io::Document document_;  // of what is being read
    Workspace workspace_;    // its
    std::string about_;
    // Of the last autosave.
    std::optional<std::size_t> revision_;
    Placed placed_;
    double last_s_ = 0;
    std::future<std::string> writing_;
    std::optional<std::string> message_;
};

}  // namespace talus::app

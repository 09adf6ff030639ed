#pragma once
#include <functional>
#include <optional>
#include <string>

#include "app/core/session.h"
#include "app/core/work.h"

namespace talus::app {

/// Makes tiles that a session looks at ready (open_tiled()) on a thread of its own, which lets others go
/// first, while the session is worked with. Where they have no overviews, those are made first, and shown as
/// a sketch.
class Preparation {
  public:
    /// note: keeps a sentence in the log.
    Preparation(Session& session, std::function<void(const std::string&)> note);

    /// Once a loop of the window, drawn or not: begins what the scene needs, gives up what it does not need
    /// any more, and hands over what is ready. Throws what the thread threw, once; then the scene stays as it
    /// is, and nothing is tried again before another one was opened, or this one anew.
    void poll();
    /// Ends the work: what is shown stays as it is, until the scene is opened anew.
    void give_up();
    const Work& work() const { return work_; }
    /// Whether the bar stands elsewhere than when this was asked last.
    bool take_progress();

  private:
    void begin(const TiledRequest& tiles);
    void measure(const TiledRequest& tiles);
    void show(TiledTerrain tiles);
    void refuse();

    Session& session_;
    std::function<void(const std::string&)> note_;
    std::optional<TiledRequest> begun_;
    std::optional<int> refused_;  // the session's terrain for which nothing is tried
    int shown_percent_ = -1;
    Work work_;  // last: its thread ends before what it looks at goes
};

}  // namespace talus::app

#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/core/dialogs.h"
#include "app/core/recovery.h"
#include "app/core/session.h"
#include "app/core/work.h"
#include "sim/io/put_back.h"

namespace talus::app {

/// A session's files: opens, saves, exports and imports them, on a thread where that takes long; asks before
/// unsaved work or a file is lost; keeps what is unsaved against crashes.
class Project {
  public:
    /// What the window does for it.
    struct Voice {
        std::function<void(const std::string&)> tell;  ///< shows a sentence, and keeps it in the log
        std::function<void(const std::string&)> note;  ///< keeps it in the log
        std::function<void()> changed;                 ///< title and picture may be others now
        std::function<void()> opened;                  ///< another scene was begun
    };
    Project(Session& session, PanelState& state, std::string journal_path, Voice voice);

    /// Once a loop of the window, drawn or not: autosave, and what threads have done. May throw what they
    /// threw.
    void poll();
    /// True while something goes on that poll() waits for.
    bool busy() const { return work_.busy() || recovery_.busy(); }
    const Work& work() const { return work_; }
    /// Gives up the work that goes on.
    void cancel();

    /// What panels asked for of files. After the frame's panels; not while work goes on.
    void serve(const PanelRequests& asked);
    /// Does it, once unsaved work is saved or given up.
    void when_saved(const std::function<void()>& act);
    /// An orderly end: nothing is left behind.
    void end() {
        cancel_self_check();
        recovery_.end();
    }
    void write_journal() const;

  private:
    void when_replaceable(const std::string& path, const std::function<void()>& act);
    void follow_dialogs(const PanelRequests& asked);
    void open(const SceneRequest& request);
    void save(const std::string& path, const std::function<void()>& then);
    void save_scene(const std::string& path);
    /// What a document keeps besides the terrain.
    Workspace workspace();
    void export_files(const io::ExportSettings& settings);
    void put_back(const std::string& path);
    void write_back(const std::shared_ptr<io::Document>& document, const io::PutBackSettings& settings);
    void look_at(const ImportWish& wish);
    void verify();
    void act_on_map(const Operation& operation);
    void take_raster(const std::string& path);
    /// `then`: after it was done.
    void act_when_ready(const std::string& name, const std::function<Operation()>& make,
                        const std::function<void()>& then = nullptr);
    void reset();
    void remember(const std::string& path);
    void forget_recovered();

    Session& session_;
    PanelState& state_;
    std::string journal_path_;
    Voice voice_;
    Recovery recovery_;
    std::optional<LeftBehind> recovering_;  // what the session was recovered from, until it is saved
    std::function<void()> after_saving_;    // waits for the name that is being asked for
    Work work_;                             // last: its thread ends before what it looks at goes
};

}  // namespace talus::app

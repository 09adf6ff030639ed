#include "app/core/recovery.h"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/core/session.h"
#include "app/core/user_folders.h"
#include "app/core/wall_clock.h"
#include "sim/io/atomic_file.h"
#include "sim/io/document.h"
#include "sim/preset.h"

namespace talus::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

fs::path sessions_folder() {
    return state_folder() / "sessions";
}

// The lock of a session that is alive cannot be had. -1: it cannot be had, or there is none.
int lock_of(const fs::path& folder, int flags) {
    const int file = ::open((folder / "lock").c_str(), flags | O_CLOEXEC, 0600);
    if (file < 0) return -1;
    if (::flock(file, LOCK_EX | LOCK_NB) == 0) return file;
    ::close(file);
    return -1;
}

}  // namespace

std::vector<LeftBehind> left_behind() {
    std::vector<LeftBehind> left;
    std::error_code failed;
    for (fs::directory_iterator at(sessions_folder(), failed), end; !failed && at != end;
         at.increment(failed)) {
        const fs::path folder = at->path();
        const int lock = lock_of(folder, O_RDWR);
        if (lock < 0) continue;
        std::error_code ignored;
        if (fs::is_regular_file(folder / "autosave.exr", ignored)) {
            LeftBehind one{folder, folder / "autosave.exr", "", "", ""};
            try {
                const json about = json::parse(io::read_text(folder / "about.json"));
                one.title = about.at("title");
                one.project = about.at("project");
                one.saved_at = about.at("saved_at");
            } catch (const std::exception&) {
                one.title = "unnamed";
            }
            left.push_back(std::move(one));
        } else {
            fs::remove_all(folder, ignored);
        }
        ::close(lock);
    }
    std::sort(left.begin(), left.end(),
              [](const LeftBehind& a, const LeftBehind& b) { return a.saved_at > b.saved_at; });
    return left;
}

void forget(const LeftBehind& left) {
    std::error_code ignored;
    fs::remove_all(left.folder, ignored);
}

Recovery::Recovery() : last_s_(wall_clock_s()) {
    std::error_code failed;
    const auto stamp = std::chrono::system_clock::now().time_since_epoch() / std::chrono::milliseconds(1);
    folder_ = sessions_folder() / fmt::format("{}-{}", ::getpid(), stamp);
    fs::create_directories(folder_, failed);
    if (!failed) lock_ = lock_of(folder_, O_RDWR | O_CREAT);
    if (lock_ < 0) why_ = fmt::format("nothing is saved by itself: '{}' cannot be written", folder_.string());
}

Recovery::~Recovery() {
    if (writing_.valid()) writing_.wait();
    if (lock_ >= 0) ::close(lock_);
}

void Recovery::end() {
    if (writing_.valid()) writing_.wait();
    std::error_code ignored;
    if (lock_ >= 0) fs::remove_all(folder_, ignored);
}

void Recovery::follow(const Session& session, const std::function<Workspace()>& workspace,
                      double interval_s) {
    if (lock_ < 0) return;
    if (writing_.valid()) {
        if (writing_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
        message_ = writing_.get();
    }
    if (auto state = readback_.poll()) {
        state->clock = document_.state.clock;
        state->springs = document_.state.springs;
        state->drives = document_.state.drives;
        state->events = document_.state.events;
        state->edges_since_s = document_.state.edges_since_s;
        state->georeference = document_.state.georeference;
        document_.state = std::move(*state);
        writing_ = std::async(std::launch::async,
                              [document = std::move(document_), workspace = std::move(workspace_),
                               about = about_, folder = folder_]() mutable -> std::string {
                                  try {
                                      document.workspace = workspace_text(workspace);
                                      io::save_document(folder / "autosave.exr", document);
                                      io::write_atomically(folder / "about.json", about);
                                      return "";
                                  } catch (const std::exception& error) {
                                      return fmt::format("nothing was saved by itself: {}", error.what());
                                  }
                              });
        document_ = {};
        workspace_ = {};
        return;
    }
    const Simulation& simulation = session.simulation();
    if (readback_.pending() || wall_clock_s() - last_s_ < interval_s || simulation.mid_tick() ||
        !session.unsaved())
        return;
    const Placed placed = session.placed();
    if (session.revision() == revision_ && placed == placed_) return;
    last_s_ = wall_clock_s();
    revision_ = session.revision();
    placed_ = placed;
    document_.state = simulation.moment_state();
    document_.cut_out = session.scene().document.cut_out;
    document_.parameters = to_toml(simulation.parameters());
    workspace_ = workspace();
    about_ = json{{"title", session.scene().title},
                  {"project", session.path()},
                  {"saved_at", fmt::format("{:%Y-%m-%d %H:%M:%S}", fmt::localtime(std::time(nullptr)))}}
                 .dump(2);
    readback_.start(simulation.terrain());
}

void Recovery::forget_work() {
    readback_.cancel();
    if (writing_.valid()) writing_.wait();
    if (writing_.valid()) writing_.get();
    last_s_ = wall_clock_s();
    revision_.reset();
    std::error_code ignored;
    fs::remove(folder_ / "autosave.exr", ignored);
    fs::remove(folder_ / "about.json", ignored);
}

std::optional<std::string> Recovery::take_message() {
    std::optional<std::string> message = std::move(message_);
    message_.reset();
    return message && !message->empty() ? message : std::nullopt;
}

}  // namespace talus::app

#include "app/core/project.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <utility>

#include "app/core/opening.h"
#include "app/core/outputs.h"
#include "app/core/recent_files.h"
#include "app/core/scene_file.h"
#include "app/core/sources.h"
#include "app/core/tiled_terrain.h"
#include "sim/io/atomic_file.h"
#include "sim/io/put_back.h"
#include "sim/io/time_series_file.h"

namespace talus::app {

Project::Project(Session& session, PanelState& state, std::string journal_path, Voice voice)
    : session_(session), state_(state), journal_path_(std::move(journal_path)), voice_(std::move(voice)) {
    if (!recovery_.why().empty()) voice_.tell(recovery_.why());
    state_.left = left_behind();
    if (!session_.request().input.empty())
        remember(session_.request().input);
    else if (is_scene(session_.request().preset))
        remember(session_.request().preset);
    state_.recent = recent_files();
}

void Project::poll() {
    recovery_.follow(
        session_, [this] { return workspace(); }, session_.view().number("autosave.interval_s"));
    if (const auto message = recovery_.take_message()) voice_.tell(*message);
    work_.poll();
}

Workspace Project::workspace() {
    Workspace kept = session_.workspace();
    kept.panel = state_.shown;
    kept.panels_shown = state_.panels_shown;
    return kept;
}

void Project::cancel() {
    cancel_self_check();
    work_.cancel();
    after_saving_ = nullptr;
}

void Project::write_journal() const {
    // What is looked at alone has no journal.
    if (!journal_path_.empty() && !session_.overflight()) session_.write_journal_to(journal_path_);
}

void Project::remember(const std::string& path) {
    remember_file(path);
    state_.recent = recent_files();
}

void Project::forget_recovered() {
    if (recovering_) forget(*recovering_);
    recovering_.reset();
    recovery_.forget_work();
}

void Project::serve(const PanelRequests& asked) {
    follow_dialogs(asked);
    if (asked.import) {
        SceneRequest request;
        request.input = *asked.import;
        // What can be looked at alone has no dialog that asks how.
        if (is_scene(*asked.import)) {
            request.preset = std::exchange(request.input, "");
            when_saved([this, request] { open(session_.request_for(request)); });
        } else if (io::is_document(*asked.import) || is_in_tiles(request)) {
            when_saved([this, request] {
                state_.start_page = false;
                open(session_.request_for(request));
            });
        } else {
            look_at({*asked.import});
        }
    }
    if (asked.import_shown) look_at({*asked.import_shown});
    if (asked.look_at) look_at(*asked.look_at);
    if (asked.import_here)
        act_when_ready(fmt::format("Importing {}", asked.import_here->path),
                       [wish = *asked.import_here] { return read_import(wish.path, wish.settings); });
    if (asked.open) when_saved([this, request = *asked.open] { open(session_.request_for(request)); });
    if (asked.save) {
        const auto then = std::exchange(after_saving_, nullptr);
        when_replaceable(*asked.save, [this, path = *asked.save, then] { save(path, then); });
    }
    if (asked.stamp)
        act_when_ready(fmt::format("Reading {}", *asked.stamp),
                       [path = *asked.stamp] { return read_stamp(path, {}); });
    if (asked.table) {
        // A tick that is half done ends first.
        session_.pause();
        const double begins_s = state_.table_begins_now ? session_.simulation().clock().simulated_s : 0;
        act_when_ready(fmt::format("Reading {}", *asked.table),
                       [path = *asked.table, name = state_.table_of, begins_s] {
                           return DriveParameter{name, io::read_time_series(path).later_by(begins_s)};
                       });
    }
    if (asked.raster) take_raster(*asked.raster);
    if (asked.export_to) state_.write.settings.path = *asked.export_to;
    if (asked.write)
        when_replaceable(asked.write->path.string(),
                         [this, settings = *asked.write] { export_files(settings); });
    if (asked.save_scene)
        when_replaceable(*asked.save_scene, [this, path = *asked.save_scene] { save_scene(path); });
    if (asked.put_back) put_back(*asked.put_back);
    if (asked.map) act_on_map(*asked.map);
    if (asked.verify) verify();
    if (asked.reset) when_saved([this] { reset(); });
}

// If the save dialog was closed without a name, the act that waited for the save is dropped.
void Project::follow_dialogs(const PanelRequests& asked) {
    if (state_.dialog.purpose == FileDialog::Purpose::none && !asked.save && !asked.answer)
        after_saving_ = nullptr;
}

void Project::when_saved(const std::function<void()>& act) {
    if (work_.busy()) return voice_.tell(fmt::format("{} goes on: wait for it", work_.name()));
    if (!session_.unsaved()) return act();
    Question question;
    question.text = fmt::format("'{}' was changed and not saved. Save it first?", session_.scene().title);
    question.answers.push_back({"Save", [this, act] {
                                    if (!session_.path().empty()) return save(session_.path(), act);
                                    state_.dialog.begin(FileDialog::Purpose::save, "");
                                    after_saving_ = act;
                                }});
    // What is dropped goes once the act has succeeded.
    question.answers.push_back({"Drop the changes", act, true});
    question.answers.push_back({"Cancel", [] {}, true});
    state_.question = std::move(question);
    voice_.changed();
}

// Does it, once a file that is there and not the session's own may be replaced.
void Project::when_replaceable(const std::string& path, const std::function<void()>& act) {
    std::error_code ignored;
    if (path == session_.path() || !std::filesystem::exists(path, ignored)) return act();
    Question question;
    question.text = fmt::format("'{}' is there already. Replace it?", path);
    question.answers.push_back({"Replace it", act});
    question.answers.push_back({"Cancel", [] {}, true});
    state_.question = std::move(question);
    voice_.changed();
}

// The layers are read now and written on a thread of their own; what is done meanwhile stays unsaved.
void Project::save(const std::string& path, const std::function<void()>& then) {
    session_.pause();
    auto document = std::make_shared<io::Document>(session_.document());
    const std::size_t revision = session_.revision();
    const auto write = [this, path, document, kept = workspace(), revision,
                        then](const Progress&) -> Work::Then {
        document->workspace = workspace_text(kept);
        write_terrain(path, *document, "", std::nullopt);
        return [this, path, revision, then] {
            session_.saved(path, revision);
            remember(path);
            forget_recovered();
            write_journal();
            voice_.tell(fmt::format("saved {}", path));
            voice_.changed();
            if (then) then();
        };
    };
    work_.start(fmt::format("Saving {}", path), write, false);
}

void Project::save_scene(const std::string& path) {
    const std::string text = scene_text(std::filesystem::path(path).stem().string(), session_);
    io::write_atomically(path, text);
    remember(path);
    voice_.tell(fmt::format(
        "saved the scene {}: the terrain as it was generated, settings and events; tables, springs, rasters "
        "and what was done to the ground are in documents alone",
        path));
}

void Project::open(const SceneRequest& request) {
    const auto left = std::find_if(state_.left.begin(), state_.left.end(),
                                   [&](const LeftBehind& one) { return one.document == request.input; });
    std::optional<LeftBehind> recovering;
    if (left != state_.left.end()) recovering = *left;
    const auto make = [this, request, recovering](const Progress&) -> Work::Then {
        auto scene = std::make_shared<Scene>(open_scene_at_once(request));
        return [this, request, scene, recovering] {
            session_.open(request, std::move(*scene));
            state_.start_page = false;
            forget_recovered();
            if (recovering) {
                session_.recovered(recovering->project, recovering->title);
                std::erase_if(state_.left,
                              [&](const LeftBehind& one) { return one.folder == recovering->folder; });
            } else if (!request.input.empty()) {
                remember(request.input);
            } else if (is_scene(request.preset)) {
                remember(request.preset);
            }
            recovering_ = recovering;
            for (const std::string& guess : session_.scene().document.notes) voice_.note("note: " + guess);
            voice_.changed();
            voice_.opened();
        };
    };
    const std::string& name = !request.title.empty()  ? request.title
                              : request.input.empty() ? request.preset
                                                      : request.input;
    work_.start(fmt::format("Opening {}", name), make);
}

void Project::reset() {
    session_.reset();
    forget_recovered();
    voice_.changed();
    voice_.opened();
}

void Project::export_files(const io::ExportSettings& settings) {
    session_.pause();
    auto document = std::make_shared<io::Document>(session_.document());
    const auto write = [this, settings, document](const Progress&) -> Work::Then {
        io::Exported exported;
        try {
            exported = io::export_terrain(*document, settings);
        } catch (const std::exception& failed) {
            return [this, message = std::string(failed.what())] {
                state_.write.error = message;
                voice_.tell(message);
            };
        }
        return [this, exported] {
            state_.write.close();
            const std::size_t more = exported.files.size() - 1;
            voice_.tell(fmt::format("wrote {}{}", exported.files.front().string(),
                                    more > 0 ? fmt::format(" and {} more", more) : ""));
            for (const auto& [name, value] : exported.values) voice_.note(fmt::format("{}: {}", name, value));
        };
    };
    work_.start(fmt::format("Writing {}", settings.path.string()), write);
}

// Asks before work that was put back earlier is lost, or what others changed in the whole since.
void Project::put_back(const std::string& path) {
    session_.pause();
    auto document = std::make_shared<io::Document>(session_.document());
    const io::CutOut& whole = document->cut_out.value();
    const bool changed = io::TiledFile(whole.path, whole.import).fingerprint() != whole.fingerprint;
    std::error_code ignored;
    const bool replaces = std::filesystem::exists(path, ignored);
    const io::PutBackSettings settings{path, session_.view().number("map.feather_m"), changed};
    if (!changed && !replaces) return write_back(document, settings);
    Question question;
    if (changed)
        question.text = fmt::format(
            "'{}' was changed since this was cut out of it. What changed there, within this part, goes. ",
            whole.path.string());
    if (replaces)
        question.text += fmt::format(
            "'{}' is there already. What was put back into it before goes: to keep it, cut out of that "
            "mosaic.",
            path);
    question.answers.push_back(
        {"Put it back", [this, document, settings] { write_back(document, settings); }});
    question.answers.push_back({"Cancel", [] {}, true});
    state_.question = std::move(question);
    voice_.changed();
}

void Project::write_back(const std::shared_ptr<io::Document>& document, const io::PutBackSettings& settings) {
    const std::string path = settings.mosaic.string();
    const auto write = [this, path, settings, document](const Progress& progress) -> Work::Then {
        const std::optional<io::PutBack> done = io::put_back(*document, settings, progress);
        if (!done) return [] {};
        keep_bounds_of_mosaic(*document->cut_out, path, done->rectangle);
        return [this, path, changed = done->changed] {
            voice_.tell(fmt::format("put {} samples back: {} is the whole with them", changed, path));
            remember(path);
        };
    };
    work_.start(fmt::format("Putting back into {}", path), write);
}

void Project::verify() {
    work_.start("Verifying this device, a minute or two", [this](const Progress&) -> Work::Then {
        return [this, found = run_self_check()] {
            voice_.note(found.holds ? "verified: all claims hold" : "verified: not all claims hold");
            state_.self_check = found;
            voice_.changed();
        };
    });
}

void Project::look_at(const ImportWish& wish) {
    work_.start(fmt::format("Reading {}", wish.path), [this, wish](const Progress&) -> Work::Then {
        return [this, found = preview_of(wish)] {
            state_.import.show(found);
            voice_.changed();
        };
    });
}

void Project::act_on_map(const Operation& operation) {
    session_.check_editable();
    if (!makes_terrain(operation)) return session_.apply(operation);
    session_.end_stroke();
    session_.pause();
    auto state = std::make_shared<TerrainState>(session_.simulation().read());
    act_when_ready(name_of(operation), [operation, state] { return made_ready(operation, *state); });
}

void Project::take_raster(const std::string& path) {
    const auto notes = std::make_shared<std::vector<std::string>>();
    act_when_ready(
        fmt::format("Reading {}", path),
        [path, number = state_.raster_of, grid = session_.simulation().terrain().grid(),
         georeference = session_.simulation().moment_state().georeference, notes] {
            ReadRaster read = read_raster(number, path, grid, georeference);
            *notes = std::move(read.notes);
            return read.take;
        },
        [this, notes] {
            if (!notes->empty()) voice_.tell(fmt::format("{}", fmt::join(*notes, "; ")));
        });
}

// What takes long is made ready on a thread.
void Project::act_when_ready(const std::string& name, const std::function<Operation()>& make,
                             const std::function<void()>& then) {
    session_.check_editable();
    session_.end_stroke();
    session_.pause();
    work_.start(name, [this, make, then, revision = session_.revision()](const Progress&) -> Work::Then {
        return [this, operation = make(), then, revision]() mutable {
            // It was made of what was there then.
            if (makes_terrain(operation) && session_.revision() != revision) forget_made(operation);
            session_.apply(operation);
            voice_.changed();
            if (then) then();
        };
    });
}

}  // namespace talus::app

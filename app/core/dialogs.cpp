#include "app/core/dialogs.h"

#include "app/core/wall_clock.h"

namespace talus::app {

bool PanelRequests::any() const {
    return open || save || save_scene || put_back || import || import_shown || look_at || import_here ||
           stamp || table || raster || write || map || reset || undo || redo || framing || verify ||
           !acts.empty() || !parameters.empty() || answer;
}

bool is_dialog_open(const PanelState& state) {
    return state.dialog.purpose != FileDialog::Purpose::none || !state.import.path.empty() ||
           state.write.shown || state.fresh.is_shown() || state.keys_shown || state.question.has_value() ||
           state.self_check.has_value();
}

void FileDialog::begin(Purpose what, const std::string& near) {
    std::error_code ignored;
    purpose = what;
    folder = std::filesystem::absolute(
                 near.empty() ? std::filesystem::path("terrain.exr") : std::filesystem::path(near), ignored)
                 .parent_path()
                 .lexically_normal()
                 .string();
    const std::filesystem::path proposed = near.empty() ? "terrain.exr" : near;
    name = what == Purpose::save         ? proposed.filename().string()
           : what == Purpose::save_scene ? proposed.stem().string() + ".toml"
           : what == Purpose::put_back   ? proposed.stem().string() + "-worked.vrt"
           : what == Purpose::export_to  ? proposed.filename().string()
                                         : "";
    error.clear();
    accepted = cancelled = false;
    go_to(folder);
}

void FileDialog::go_to(const std::string& another_folder) {
    folder = another_folder;
    error.clear();
    entries = entries_of(folder);
    sort();
    listed_at_s = wall_clock_s();
}

void FileDialog::follow_folder() {
    constexpr double often_enough_s = 2;
    if (wall_clock_s() - listed_at_s > often_enough_s) {
        entries = entries_of(folder);
        sort();
        listed_at_s = wall_clock_s();
    }
}

void FileDialog::begin_put_back(const Session& session) {
    begin(Purpose::put_back,
          session.path().empty() ? session.scene().document.cut_out->path.string() : session.path());
}

void ExportDialog::close() {
    shown = false;
    error.clear();
    state.reset();
    lost_with.clear();
}

void ImportDialog::show(const ImportPreview& found) {
    path = found.wish.path;
    settings = found.wish.settings;
    error = found.error;
    preview = {};
    if (!error.empty()) return;
    samples = {found.grid.nx, found.grid.ny};
    spacing_m = found.grid.dx;
    low_m = found.low_m;
    high_m = found.high_m;
    if (!settings.raw) raw_size = samples;
    notes = found.notes;
    kind = found.kind;
    crs = found.crs;
    preview_size = found.picture_size;
    preview = gpu::Texture("import preview", gpu::Format::rgba8, preview_size.x, preview_size.y);
    preview.write(preview.whole(), std::as_bytes(std::span(found.picture)));
}

}  // namespace talus::app

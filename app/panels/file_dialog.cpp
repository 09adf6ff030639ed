#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <utility>

#include "app/panels/panels.h"
#include "sim/io/endings.h"

namespace talus::app {

namespace fs = std::filesystem;

namespace {

const char* title_of(FileDialog::Purpose purpose) {
    switch (purpose) {
        case FileDialog::Purpose::save:
            return "Save as";
        case FileDialog::Purpose::put_back:
            return "Put back";
        case FileDialog::Purpose::import:
            return "Import";
        case FileDialog::Purpose::stamp:
            return "Choose a stamp";
        case FileDialog::Purpose::table:
            return "Choose a table";
        case FileDialog::Purpose::raster:
            return "Choose a raster";
        default:
            return "Open";
    }
}

void draw_entries(FileDialog& dialog) {
    std::error_code failed;
    std::vector<fs::path> entries;
    for (fs::directory_iterator at(dialog.folder, failed), end; !failed && at != end; at.increment(failed))
        entries.push_back(at->path());
    std::sort(entries.begin(), entries.end());
    if (ImGui::Selectable("..")) dialog.folder = fs::path(dialog.folder).parent_path().string();
    for (const fs::path& entry : entries) {
        const std::string shown = entry.filename().string();
        if (shown.starts_with(".")) continue;
        if (fs::is_directory(entry, failed)) {
            if (ImGui::Selectable((shown + "/").c_str())) dialog.folder = entry.string();
        } else if (ImGui::Selectable(shown.c_str(), shown == dialog.name,
                                     ImGuiSelectableFlags_AllowDoubleClick)) {
            dialog.name = shown;
            if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) dialog.accepted = true;
        }
        note_widget("file " + shown);
    }
}

void accept(FileDialog& dialog, PanelRequests& requests) {
    const fs::path given(dialog.name);
    std::string path = (given.is_absolute() ? given : fs::path(dialog.folder) / given).string();
    if (dialog.purpose == FileDialog::Purpose::save) {
        path = io::with_ending(path, ".exr").string();
        // Save keeps everything; other formats are exports.
        if (io::ending_of(path) != ".exr") {
            dialog.error = "a Talus document ends in .exr; other formats are under File > Export";
            return;
        }
        requests.save = path;
    } else if (dialog.purpose == FileDialog::Purpose::put_back) {
        path = io::with_ending(path, ".vrt").string();
        if (io::ending_of(path) != ".vrt") {
            dialog.error = "a mosaic ends in .vrt";
            return;
        }
        requests.put_back = path;
    } else if (dialog.purpose == FileDialog::Purpose::stamp) {
        requests.stamp = path;
    } else if (dialog.purpose == FileDialog::Purpose::table) {
        requests.table = path;
    } else if (dialog.purpose == FileDialog::Purpose::raster) {
        requests.raster = path;
    } else if (dialog.purpose == FileDialog::Purpose::import) {
        requests.look_at = {path};
    } else {
        requests.import = path;
    }
    dialog.purpose = FileDialog::Purpose::none;
}

}  // namespace

void draw_file_dialog(PanelContext& context) {
    FileDialog& dialog = context.state.dialog;
    if (dialog.purpose == FileDialog::Purpose::none) return;
    const char* title = title_of(dialog.purpose);
    const float em = ImGui::GetFontSize();
    if (!begin_dialog(title, 38, 28)) return;
    text_line(dialog.folder);
    ImGui::BeginChild("files", {0, -7 * em}, true);
    draw_entries(dialog);
    ImGui::EndChild();
    ImGui::SetNextItemWidth(-1);
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    const bool entered = ImGui::InputText("##name", &dialog.name, ImGuiInputTextFlags_EnterReturnsTrue);
    note_widget("file name");
    const bool accepted = button(title) || entered || std::exchange(dialog.accepted, false);
    ImGui::SameLine();
    const bool cancelled = button("Cancel") || dialog.cancelled;
    if (!dialog.error.empty()) ImGui::TextWrapped("%s", dialog.error.c_str());
    if (accepted && !dialog.name.empty()) accept(dialog, context.requests);
    if (cancelled) dialog.purpose = FileDialog::Purpose::none;
    if (dialog.purpose == FileDialog::Purpose::none) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace talus::app

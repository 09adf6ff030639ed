#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <utility>

#include "app/panels/panels.h"
#include "sim/io/heightmap.h"

namespace talus {

namespace fs = std::filesystem;

void FileDialog::begin(Purpose what, const std::string& near) {
    std::error_code ignored;
    purpose = what;
    folder = fs::absolute(near.empty() ? fs::path("terrain.exr") : fs::path(near), ignored)
                 .parent_path()
                 .lexically_normal()
                 .string();
    name = what == Purpose::save ? (near.empty() ? "terrain.exr" : fs::path(near).filename().string()) : "";
    error.clear();
    accepted = cancelled = false;
}

void draw_file_dialog(FileDialog& dialog, PanelRequests& requests) {
    if (dialog.purpose == FileDialog::Purpose::none) return;
    const bool saving = dialog.purpose == FileDialog::Purpose::save;
    const char* title = saving ? "Save as" : "Open";
    ImGui::OpenPopup(title);
    ImGui::SetNextWindowSize({560, 420}, ImGuiCond_Appearing);
    if (!ImGui::BeginPopupModal(title)) return;
    ImGui::TextUnformatted(dialog.folder.c_str());
    ImGui::BeginChild("files", {0, -70}, true);
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
        } else if (ImGui::Selectable(shown.c_str(), shown == dialog.name)) {
            dialog.name = shown;
        }
    }
    ImGui::EndChild();
    ImGui::SetNextItemWidth(-1);
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    const bool entered = ImGui::InputText("##name", &dialog.name, ImGuiInputTextFlags_EnterReturnsTrue);
    const bool accepted = ImGui::Button(title) || entered || std::exchange(dialog.accepted, false);
    ImGui::SameLine();
    const bool cancelled = ImGui::Button("Cancel") || dialog.cancelled;
    ImGui::SameLine();
    ImGui::TextUnformatted(saving ? (dialog.error.empty() ? heightmap_endings : dialog.error.c_str()) : "");
    if (accepted && !dialog.name.empty()) {
        const fs::path given(dialog.name);
        const std::string path = (given.is_absolute() ? given : fs::path(dialog.folder) / given).string();
        if (saving && !can_write_heightmap(path)) {
            dialog.error = std::string("the ending must be one of ") + heightmap_endings;
        } else {
            (saving ? requests.save : requests.open) = path;
            dialog.purpose = FileDialog::Purpose::none;
        }
    }
    if (cancelled) dialog.purpose = FileDialog::Purpose::none;
    if (dialog.purpose == FileDialog::Purpose::none) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace talus

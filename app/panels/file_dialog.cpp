#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "app/panels/panels.h"
#include "sim/error.h"
#include "sim/io/endings.h"
#include "sim/io/heightmap_formats.h"

namespace talus::app {

namespace fs = std::filesystem;

namespace {

using Endings = std::vector<std::string>;

// Heightmaps, and what else opens as a scene.
Endings scenes_and_heightmaps() {
    Endings endings = io::readable_endings();
    endings.emplace_back(".toml");
    return endings;
}

// What a dialog is for.
struct FilePurpose {
    FileDialog::Purpose purpose;
    const char* title;
    std::optional<std::string> PanelRequests::*request;  // that its path goes to
    Endings (*listed)();                                 // endings of the files that it lists; null: all
    const char* ending = "";   // that a file must have which is written; completed where it is missing
    const char* refusal = "";  // of other endings
};

using Purpose = FileDialog::Purpose;
constexpr std::array<FilePurpose, 9> file_purposes = {{
    {Purpose::open, "Open", &PanelRequests::import, scenes_and_heightmaps},
    {Purpose::save, "Save as", &PanelRequests::save, [] { return Endings{".exr"}; }, ".exr",
     "a Talus document ends in .exr; other formats are under File > Export"},
    {Purpose::save_scene, "Save as a scene", &PanelRequests::save_scene, [] { return Endings{".toml"}; },
     ".toml", "a scene ends in .toml"},
    {Purpose::put_back, "Put back", &PanelRequests::put_back, [] { return Endings{".vrt"}; }, ".vrt",
     "a mosaic ends in .vrt"},
    {Purpose::import, "Import", &PanelRequests::import_shown, io::readable_endings},
    {Purpose::stamp, "Choose a stamp", &PanelRequests::stamp, io::readable_endings},
    {Purpose::table, "Choose a table", &PanelRequests::table,
     [] {
         return Endings{".csv", ".txt"};
     }},
    {Purpose::raster, "Choose a raster", &PanelRequests::raster, io::readable_endings},
    {Purpose::export_to, "Export to", &PanelRequests::export_to, nullptr},
}};

const FilePurpose& purpose_of(const FileDialog& dialog) {
    return *std::find_if(file_purposes.begin(), file_purposes.end(),
                         [&](const FilePurpose& one) { return one.purpose == dialog.purpose; });
}

// Of the folder's entries those that the purpose has use for, by their places.
std::vector<std::size_t> listed(const FilePurpose& purpose, const FileDialog& dialog) {
    const Endings endings = purpose.listed ? purpose.listed() : Endings();
    const bool all = dialog.all_files || !purpose.listed;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < dialog.entries.size(); ++i) {
        const FolderEntry& entry = dialog.entries[i];
        if (all || entry.is_folder ||
            std::find(endings.begin(), endings.end(), entry.ending) != endings.end())
            places.push_back(i);
    }
    return places;
}

// Sorted as the columns' heads say.
void follow_sorting(FileDialog& dialog) {
    const ImGuiTableSortSpecs* wish = ImGui::TableGetSortSpecs();
    if (!wish || wish->SpecsCount == 0) return;
    const auto by = static_cast<ListedBy>(wish->Specs->ColumnUserID);
    const bool descending = wish->Specs->SortDirection == ImGuiSortDirection_Descending;
    if (by == dialog.by && descending == dialog.descending) return;
    dialog.by = by;
    dialog.descending = descending;
    dialog.sort();
}

// A click takes a file's name, a double click the file, or goes into the folder. Returns where to go; none:
// nowhere.
std::optional<std::string> draw_entry(FileDialog& dialog, const FolderEntry& entry) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    constexpr int flags = ImGuiSelectableFlags_AllowDoubleClick | ImGuiSelectableFlags_SpanAllColumns;
    const bool pressed = selectable_text(entry.is_folder ? entry.name + "/" : entry.name,
                                         !entry.is_folder && entry.name == dialog.name, flags);
    note_widget("file " + entry.name);
    ImGui::TableNextColumn();
    if (!entry.is_folder) ImGui::TextUnformatted(size_text(entry.bytes).c_str());
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(time_text(entry.changed).c_str());
    const bool twice = pressed && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    if (twice && entry.is_folder) return (fs::path(dialog.folder) / entry.name).string();
    if (pressed && !entry.is_folder) dialog.name = entry.name;
    if (twice) dialog.accepted = true;
    return std::nullopt;
}

void draw_entries(FileDialog& dialog, float height) {
    constexpr int flags = ImGuiTableFlags_Sortable | ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg |
                          ImGuiTableFlags_BordersOuter | ImGuiTableFlags_NoSavedSettings;
    if (!ImGui::BeginTable("files", 3, flags, {0, height})) return;
    const float em = ImGui::GetFontSize();
    const auto column = [](const char* name, int also, float width, ListedBy by) {
        ImGui::TableSetupColumn(name, also, width, static_cast<ImGuiID>(by));
    };
    ImGui::TableSetupScrollFreeze(0, 1);
    column("Name", ImGuiTableColumnFlags_WidthStretch | ImGuiTableColumnFlags_DefaultSort, 0, ListedBy::name);
    column("Size", ImGuiTableColumnFlags_WidthFixed | ImGuiTableColumnFlags_PreferSortDescending, 5 * em,
           ListedBy::size);
    column("Changed", ImGuiTableColumnFlags_WidthFixed | ImGuiTableColumnFlags_PreferSortDescending,
           9.5F * em, ListedBy::changed);
    ImGui::TableHeadersRow();
    follow_sorting(dialog);
    const std::vector<std::size_t> places = listed(purpose_of(dialog), dialog);
    std::optional<std::string> another;
    // Folders of thousands of files: those in sight are drawn.
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(places.size()));
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
            if (auto folder = draw_entry(dialog, dialog.entries[places[static_cast<std::size_t>(i)]]))
                another = std::move(folder);
    ImGui::EndTable();
    if (another) dialog.go_to(*another);
}

// The way to the folder above, and to folders of files that were opened lately.
void draw_folder(FileDialog& dialog, const std::vector<std::string>& recent) {
    if (button("Up", "the folder above")) dialog.go_to(fs::path(dialog.folder).parent_path().string());
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1);
    if (!ImGui::BeginCombo("##folder", dialog.folder.c_str())) return note_widget("recent folders");
    close_on_escape();
    std::vector<std::string> folders;
    for (const std::string& file : recent) {
        const std::string folder = fs::path(file).parent_path().string();
        if (std::find(folders.begin(), folders.end(), folder) == folders.end()) folders.push_back(folder);
    }
    for (std::size_t i = 0; i < folders.size(); ++i) {
        if (ImGui::Selectable(folders[i].c_str(), folders[i] == dialog.folder)) dialog.go_to(folders[i]);
        note_widget("recent folder " + std::to_string(i));
    }
    ImGui::EndCombo();
}

void accept(FileDialog& dialog, PanelRequests& requests) {
    const FilePurpose& purpose = purpose_of(dialog);
    const fs::path given(dialog.name);
    fs::path path = given.is_absolute() ? given : fs::path(dialog.folder) / given;
    const std::string ending = purpose.ending;
    std::error_code ignored;
    // A folder's name goes there; where a file is to be written, with its slash alone.
    const bool may_be_folder = ending.empty() || dialog.name.ends_with('/') || dialog.name == "..";
    if (may_be_folder && fs::is_directory(path, ignored)) {
        path = path.lexically_normal();
        // "folder/" ends with an empty name.
        dialog.go_to((path.has_filename() || !path.has_relative_path() ? path : path.parent_path()).string());
        dialog.name.clear();
        return;
    }
    if (!ending.empty() && io::ending_of(path) != ending) {
        path = io::with_ending(path, ending);
        if (io::ending_of(path) != ending) {
            dialog.error = purpose.refusal;
            return;
        }
    }
    if (fs::is_directory(path, ignored)) {
        dialog.error = "'" + path.string() + "' is a folder: name a file";
        return;
    }
    requests.*purpose.request = path.string();
    dialog.purpose = Purpose::none;
}

void ask_desktop(FileDialog& dialog, const FilePurpose& purpose) {
    const fs::path named(dialog.name);
    const fs::path near = named.is_absolute() ? named : fs::path(dialog.folder) / named;
    const bool saves = *purpose.ending != '\0' || purpose.purpose == Purpose::export_to;
    try {
        dialog.desktop = std::make_unique<DesktopDialog>(
            FileQuestion{purpose.title, near.string(), saves, purpose.listed ? purpose.listed() : Endings()});
    } catch (const Error& error) {
        dialog.error = error.what();
    }
}

// What was chosen there is taken as if it were typed here.
bool is_answered_by_desktop(FileDialog& dialog) {
    if (!dialog.desktop) return false;
    ImGui::TextWrapped("The desktop's dialog is open: choose there. Cancel closes it.");
    const std::optional<std::string> chosen = dialog.desktop->answer();
    if (!chosen) return false;
    dialog.desktop.reset();
    if (chosen->empty()) return false;
    dialog.name = *chosen;
    return true;
}

}  // namespace

void draw_file_dialog(PanelContext& context) {
    FileDialog& dialog = context.state.dialog;
    if (dialog.purpose == Purpose::none) return;
    const FilePurpose& purpose = purpose_of(dialog);
    const float em = ImGui::GetFontSize();
    if (!begin_dialog(purpose.title, 46, 30)) return;
    // Keys are the list's while one is open.
    if (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId)) dialog.cancelled = dialog.accepted = false;
    dialog.follow_folder();
    draw_folder(dialog, context.state.recent);
    draw_entries(dialog, ImGui::GetContentRegionAvail().y - 5 * em);
    ImGui::SetNextItemWidth(-1);
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    const bool entered = ImGui::InputText("##name", &dialog.name, ImGuiInputTextFlags_EnterReturnsTrue);
    note_widget("file name");
    const bool accepted = button(purpose.title) || entered || std::exchange(dialog.accepted, false);
    ImGui::SameLine();
    const bool cancelled = button("Cancel") || dialog.cancelled;
    if (!DesktopDialog::program().empty()) {
        ImGui::SameLine();
        if (button("Desktop's dialog…", DesktopDialog::program().c_str()) && !dialog.desktop)
            ask_desktop(dialog, purpose);
    }
    if (purpose.listed) {
        ImGui::SameLine();
        ImGui::Checkbox("all files", &dialog.all_files);
        note_widget("all files");
    }
    if (!dialog.error.empty()) ImGui::TextWrapped("%s", dialog.error.c_str());
    const bool answered = is_answered_by_desktop(dialog);
    if ((accepted || answered) && !dialog.name.empty()) accept(dialog, context.requests);
    if (cancelled) dialog.purpose = Purpose::none;
    if (dialog.purpose == Purpose::none) {
        dialog.desktop.reset();
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

}  // namespace talus::app

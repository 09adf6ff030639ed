#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/panels/panels.h"
#include "app/panels/style.h"
#include "sim/error.h"
#include "sim/io/heightmap_formats.h"

namespace talus::app {
namespace {

bool is_raw(const std::string& path) {
    const io::HeightmapFormat* format = io::format_of(path);
    return format && format->headerless;
}

// Whether they are others now.
bool draw_settings(ImportDialog& dialog) {
    bool changed = false;
    label_before("Metres a sample");
    ImGui::InputDouble("##spacing", &dialog.spacing_m, 0, 0, "%.6g");
    note_widget("import spacing");
    if (ImGui::IsItemDeactivatedAfterEdit() && dialog.spacing_m > 0) {
        dialog.settings.spacing_m = dialog.spacing_m;
        changed = true;
    }
    for (auto& [name, height] : {std::pair<const char*, double&>("Smallest value, m", dialog.low_m),
                                 std::pair<const char*, double&>("Largest value, m", dialog.high_m)}) {
        label_before(name);
        ImGui::InputDouble((std::string("##") + name).c_str(), &height, 0, 0, "%.6g");
        note_widget(name);
        if (!ImGui::IsItemDeactivatedAfterEdit() || !(dialog.high_m > dialog.low_m)) continue;
        dialog.settings.range_m = glm::dvec2(dialog.low_m, dialog.high_m);
        changed = true;
    }
    if (is_raw(dialog.path)) {
        label_before("Columns, rows");
        ImGui::InputInt2("##size", &dialog.raw_size.x);
        bool laid = ImGui::IsItemDeactivatedAfterEdit();
        laid = ImGui::Checkbox("big byte first", &dialog.big_endian) || laid;
        ImGui::SameLine();
        laid = ImGui::Checkbox("south row first", &dialog.south_first) || laid;
        if (laid && dialog.raw_size.x > 0 && dialog.raw_size.y > 0) {
            dialog.settings.raw =
                io::RawLayout{dialog.raw_size.x, dialog.raw_size.y, dialog.big_endian, dialog.south_first};
            changed = true;
        }
    }
    return changed;
}

}  // namespace

void draw_import_dialog(PanelContext& context) {
    ImportDialog& dialog = context.state.import;
    if (dialog.path.empty()) return;
    const float em = ImGui::GetFontSize();
    if (!begin_dialog("How the file is read", 48)) return;
    // While it is read again, what it shows is of the settings before.
    const bool waits = context.work.busy();
    ImGui::BeginDisabled(waits);
    text_line(dialog.path);
    const float side = 20 * em;
    ImGui::BeginChild("preview", {side + em, side + em});
    if (dialog.preview.width() > 0) {
        const float scale = side / static_cast<float>(std::max(dialog.preview_size.x, dialog.preview_size.y));
        ImGui::Image(panel_image(dialog.preview), {scale * static_cast<float>(dialog.preview_size.x),
                                                   scale * static_cast<float>(dialog.preview_size.y)});
    }
    ImGui::EndChild();
    ImGui::SameLine();
    ImGui::BeginChild("settings", {0, side + em});
    ImGui::PushTextWrapPos(0);
    if (dialog.error.empty()) {
        ImGui::TextUnformatted(
            fmt::format("{}, {} × {} samples", dialog.kind, dialog.samples.x, dialog.samples.y).c_str());
        if (!dialog.crs.empty()) ImGui::TextUnformatted(dialog.crs.c_str());
        for (const std::string& note : dialog.notes) {
            ImGui::Bullet();
            ImGui::TextUnformatted(note.c_str());
        }
    } else {
        coloured_text(theme().warning, dialog.error);
    }
    ImGui::PopTextWrapPos();
    ImGui::Spacing();
    // It is read again on a thread, and shown between two frames: this one still draws the picture before.
    if (draw_settings(dialog)) context.requests.look_at = {dialog.path, dialog.settings};
    ImGui::EndChild();
    ImGui::EndDisabled();
    // What is pressed while the file is read again is done when that has ended.
    const bool good = dialog.error.empty();
    if (button("Open it", "as a scene of its own", good)) dialog.then = ImportDialog::Then::open;
    ImGui::SameLine();
    if (button("Import it", "in place of this terrain, as an act that can be undone; settings go on",
               good && !context.state.only_looks))
        dialog.then = ImportDialog::Then::import_here;
    if (!good) dialog.then = ImportDialog::Then::stay;
    bool ended = false;
    if (!waits && !context.requests.look_at && dialog.then != ImportDialog::Then::stay) {
        if (dialog.then == ImportDialog::Then::open) {
            SceneRequest request;
            request.input = dialog.path;
            request.import = dialog.settings;
            context.requests.open = request;
            context.state.start_page = false;
        } else {
            context.requests.import_here = {dialog.path, dialog.settings};
        }
        ended = true;
    }
    ImGui::SameLine();
    // While the file is read again, Cancel stops only the reading and the chosen act.
    if (button("Cancel import") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) {
        dialog.then = ImportDialog::Then::stay;
        if (waits)
            context.requests.cancel_work = true;
        else
            ended = true;
    }
    if (ended) {
        dialog.then = ImportDialog::Then::stay;
        dialog.path.clear();
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

}  // namespace talus::app

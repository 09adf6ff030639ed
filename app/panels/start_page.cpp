#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <filesystem>

#include "app/panels/panels.h"

namespace talus::app {
namespace {

void draw_left_behind(PanelContext& context) {
    PanelState& state = context.state;
    if (state.left.empty()) return;
    heading("Not saved");
    for (const LeftBehind& left : state.left) {
        ImGui::PushID(left.folder.c_str());
        text_line(fmt::format("{}, {}", left.title, left.saved_at));
        if (button("Recover", "opens what was there when Talus ended: " + left.document.string())) {
            SceneRequest request;
            request.input = left.document.string();
            context.requests.open = request;
            state.start_page = false;
        }
        ImGui::SameLine();
        const bool dropped = button("Drop it", "it is deleted");
        ImGui::PopID();
        if (!dropped) continue;
        forget(left);
        std::erase_if(state.left,
                      [folder = left.folder](const LeftBehind& one) { return one.folder == folder; });
        break;
    }
}

}  // namespace

void draw_start_page(PanelContext& context, glm::ivec2 size) {
    PanelState& state = context.state;
    const float em = ImGui::GetFontSize();
    const PictureArea area = picture_area(state, size);
    // Over the picture, or over everything where that is too narrow.
    const bool fits = static_cast<float>(area.size.x) > 30 * em;
    const auto room = static_cast<float>(fits ? area.size.x : size.x) - em;
    const ImVec2 page{std::min(56 * em, room), static_cast<float>(area.size.y) - em};
    const float middle = static_cast<float>(fits ? area.corner.x + area.size.x / 2 : size.x / 2);
    ImGui::SetNextWindowPos({middle - page.x / 2, static_cast<float>(area.corner.y) + em / 2});
    ImGui::SetNextWindowSize(page);
    if (!ImGui::Begin("Talus", &state.start_page,
                      ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                          ImGuiWindowFlags_NoSavedSettings)) {
        ImGui::End();
        return;
    }
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(
        "1  Make a new terrain, choose a scene below, or open a heightmap of your own.\n"
        "2  Space plays the simulations; hold the left button on the ground to sculpt; the right button "
        "turns.\n"
        "3  Ctrl+Z takes back anything. Ctrl+Shift+S saves, Ctrl+E exports for other programs.");
    ImGui::PopTextWrapPos();
    ImGui::Spacing();
    if (button("New terrain…", "of a kind, size and relief of your own")) state.fresh.begin();
    ImGui::SameLine();
    if (button("Open a file…", "heightmaps, Talus documents and scenes"))
        state.dialog.begin(FileDialog::Purpose::open, context.session.path());
    ImGui::SameLine();
    if (button("Go on with this scene", "closes this page")) state.start_page = false;
    draw_left_behind(context);
    const std::vector<std::string>& recent = context.state.recent;
    if (!recent.empty()) {
        heading("Recent files");
        for (std::size_t i = 0; i < std::min<std::size_t>(recent.size(), 5); ++i) {
            if (ImGui::Selectable(std::filesystem::path(recent[i]).filename().string().c_str()))
                context.requests.import = recent[i];
            note_widget(fmt::format("recent {}", i));
            tooltip_of(recent[i]);
        }
    }
    heading("Scenes");
    draw_preset_grid(context);
    ImGui::End();
}

}  // namespace talus::app

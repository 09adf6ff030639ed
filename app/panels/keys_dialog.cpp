#include <imgui.h>

#include "app/panels/panels.h"
#include "app/panels/style.h"

namespace talus::app {

void draw_keys_dialog(PanelContext& context) {
    if (!begin_dialog("Keys and mouse", 40, 36)) return;
    ImGui::BeginChild("keys", {0, -2.6F * ImGui::GetFontSize()}, true);
    for (const KeyLine& line : context.state.keys) {
        if (line.keys.empty()) {
            heading(line.what.c_str());
            continue;
        }
        coloured_text(theme().text, line.keys);
        ImGui::SameLine(14 * ImGui::GetFontSize());
        ImGui::TextWrapped("%s", line.what.c_str());
    }
    ImGui::EndChild();
    if (button("Close") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) {
        context.state.keys_shown = false;
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

}  // namespace talus::app

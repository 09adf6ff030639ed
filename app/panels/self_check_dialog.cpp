#include <imgui.h>

#include "app/panels/panels.h"
#include "app/panels/style.h"

namespace talus::app {

void draw_self_check_dialog(PanelContext& context) {
    std::optional<SelfCheck>& check = context.state.self_check;
    if (!check || !begin_dialog("This device", 50, 34)) return;
    ImGui::TextWrapped("%s", check->device.c_str());
    ImGui::TextWrapped(
        "%s", check->holds ? "Everything that Talus claims of its numbers holds here."
                           : "Not everything that Talus claims of its numbers holds here: look for a newer "
                             "driver, and report it with what 'talus verify' prints.");
    ImGui::BeginChild("claims", {0, -2.6F * ImGui::GetFontSize()}, true);
    for (const SelfCheck::Row& row : check->rows) {
        coloured_text(row.holds ? theme().good : theme().warning, row.holds ? "holds" : "FAILS");
        ImGui::SameLine(4 * ImGui::GetFontSize());
        ImGui::TextUnformatted(row.claim.c_str());
        tooltip_of(row.says);
        ImGui::SameLine(14 * ImGui::GetFontSize());
        text_line(row.found);
    }
    ImGui::EndChild();
    if (button("Close") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) {
        check.reset();
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

}  // namespace talus::app

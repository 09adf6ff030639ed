#include <imgui.h>

#include "app/panels/panels.h"

namespace talus::app {

void draw_log_panel(PanelContext& context) {
    if (button("Copy", "all lines, for a report")) {
        std::string all;
        for (const std::string& line : context.state.log) all += line + '\n';
        ImGui::SetClipboardText(all.c_str());
    }
    ImGui::SameLine();
    if (button("Save the journal…",
               "talus.journal in the folder where Talus was started: what was done here, which "
               "'talus replay' does again",
               !context.state.only_looks))
        context.requests.acts.emplace_back([](Session& s) { s.write_journal_to("talus.journal"); });
    ImGui::Separator();
    for (const std::string& line : context.state.log) ImGui::TextWrapped("%s", line.c_str());
    if (ImGui::GetScrollY() >= ImGui::GetScrollMaxY()) ImGui::SetScrollHereY(1);
}

}  // namespace talus::app

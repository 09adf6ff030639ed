#include <imgui.h>

#include "app/panels/panels.h"

namespace talus::app {

void draw_question(PanelContext& context) {
    PanelState& state = context.state;
    if (!begin_dialog("Question", 26)) return;
    ImGui::TextWrapped("%s", state.question->text.c_str());
    ImGui::Spacing();
    for (std::size_t i = 0; i < state.question->answers.size(); ++i) {
        if (i > 0) ImGui::SameLine();
        const auto& [name, act] = state.question->answers[i];
        const bool last = i + 1 == state.question->answers.size();
        if (button(name) || (last && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))))
            context.requests.answer = act;
    }
    if (context.requests.answer) {
        ImGui::CloseCurrentPopup();
        state.question.reset();
    }
    ImGui::EndPopup();
}

}  // namespace talus::app

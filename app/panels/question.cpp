#include <imgui.h>

#include "app/panels/panels.h"

namespace talus::app {

void draw_question(PanelContext& context) {
    PanelState& state = context.state;
    if (!begin_dialog("Question", 26)) return;
    ImGui::TextWrapped("%s", state.question->text.c_str());
    ImGui::Spacing();
    bool answered = false;
    for (std::size_t i = 0; i < state.question->answers.size(); ++i) {
        if (i > 0) ImGui::SameLine();
        const Question::Answer& answer = state.question->answers[i];
        const bool last = i + 1 == state.question->answers.size();
        if (!button(answer.words) && !(last && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))))
            continue;
        context.requests.answer = answer.act;
        context.requests.answer_at_once = answer.at_once;
        answered = true;
    }
    if (answered) {
        ImGui::CloseCurrentPopup();
        state.question.reset();
    }
    ImGui::EndPopup();
}

}  // namespace talus::app

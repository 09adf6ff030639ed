#include <fmt/format.h>
#include <imgui.h>

#include <cmath>

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

void draw_work(const Work& work, bool& cancelled) {
    // What is short needs no bar.
    if (!work.busy() || work.seconds() < 0.3) return;
    const ImVec2 middle = ImGui::GetMainViewport()->GetCenter();
    ImGui::SetNextWindowPos(middle, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSize({24 * ImGui::GetFontSize(), 0});
    ImGui::Begin("Work", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize);
    text_line(work.name());
    const std::optional<double> share = work.share();
    // Where the progress is unknown the bar shows that the work goes on.
    const double length = share.value_or(work.seconds() - std::floor(work.seconds()));
    const std::string left = share ? fmt::format("{:.0f} %, ", 100 * *share) : "";
    ImGui::ProgressBar(static_cast<float>(length), {-1, 0},
                       fmt::format("{}{:.0f} s", left, work.seconds()).c_str());
    cancelled = button("Cancel work", "everything stays as it was", work.can_cancel());
    ImGui::End();
}

}  // namespace talus::app

#include <fmt/format.h>
#include <imgui.h>

#include "app/panels/panels.h"

namespace talus::app {

void draw_history_panel(PanelContext& context) {
    const Undo& history = context.session.simulation().undo_history();
    const double mib = 1.0 / (1U << 20U);
    const double used = static_cast<double>(history.bytes()) * mib;
    const double cap = static_cast<double>(history.capacity()) * mib;
    ImGui::ProgressBar(static_cast<float>(used / cap), {-1, 0},
                       fmt::format("{:.1f} of {:.0f} MiB", used, cap).c_str());
    draw_parameters(context.session, context.requests, {"undo.memory_mib"});
    if (context.session.scene().document.kind == "Talus document")
        ImGui::TextWrapped("What was done before the file was saved is not kept in it.");
    ImGui::Separator();
    const std::vector<std::string> done = history.done();
    const std::vector<std::string> undone = history.undone();
    const auto line = [&](std::size_t number, const std::string& name, bool later) {
        ImGui::PushID(static_cast<int>(number));
        if (later) ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
        if (ImGui::Selectable(name.c_str(), number == done.size()))
            context.requests.acts.emplace_back([number](Session& s) { s.go_to(number); });
        if (later) ImGui::PopStyleColor();
        note_widget(fmt::format("history {}", number));
        ImGui::PopID();
    };
    line(0, "as far back as memory goes", false);
    for (std::size_t i = 0; i < done.size(); ++i) line(i + 1, fmt::format("{}  {}", i + 1, done[i]), false);
    for (std::size_t i = 0; i < undone.size(); ++i)
        line(done.size() + i + 1, fmt::format("{}  {}", done.size() + i + 1, undone[i]), true);
}

}  // namespace talus::app

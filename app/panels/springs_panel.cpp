#include <fmt/format.h>
#include <imgui.h>

#include "app/panels/panels.h"

namespace talus::app {

void draw_springs(PanelContext& context) {
    const Session& session = context.session;
    PanelRequests& requests = context.requests;
    heading("Springs");
    place_button(context.state, MarkKind::spring, "Place a spring");
    draw_parameters(session, requests, {"spring.rate_m3_per_s"});
    const std::vector<Spring>& springs = session.simulation().springs();
    for (std::size_t i = 0; i < springs.size(); ++i) {
        const Spring& spring = springs[i];
        const std::string name = fmt::format("spring {}", i + 1);
        ImGui::PushID(static_cast<int>(i));
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(fmt::format("Spring {}", i + 1).c_str());
        ImGui::SameLine();
        ImGui::SetNextItemWidth(8 * ImGui::GetFontSize());
        double rate = spring.rate_m3_per_s;
        if (number_until_let_go(context.state.numbers_in_hand, name + " rate", {"%.4g m³/s", 1e-6, 1e9},
                                rate))
            requests.acts.emplace_back([spring, rate](Session& s) { set_spring_rate(s, spring, rate); });
        ImGui::SameLine();
        const bool removed = ImGui::SmallButton("remove");
        note_widget("remove " + name);
        if (removed) requests.acts.emplace_back([spring](Session& s) { set_spring_rate(s, spring, 0); });
        if (const auto to = place_fields(context, name, {spring.x_m, spring.y_m}))
            requests.acts.emplace_back([spring, at = *to](Session& s) { move_spring(s, spring, at); });
        ImGui::PopID();
    }
}

}  // namespace talus::app

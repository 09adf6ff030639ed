#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/panels/panels.h"
#include "app/panels/style.h"

namespace talus::app {
namespace {

void draw_wishes(PanelContext& context) {
    NewTerrain& fresh = context.state.fresh;
    for (const std::string& name : fresh.heeded()) {
        Value value = fresh.wishes().value(name);
        const Edit done = draw_parameter(fresh.wishes().declaration(name), value);
        if (done == Edit::set)
            context.requests.acts.emplace_back([&fresh, name, value](Session&) { fresh.set(name, value); });
        if (done == Edit::unset)
            context.requests.acts.emplace_back([&fresh, name](Session&) { fresh.unset(name); });
    }
}

}  // namespace

void draw_new_dialog(PanelContext& context) {
    NewTerrain& fresh = context.state.fresh;
    const float em = ImGui::GetFontSize();
    if (!begin_dialog("New terrain", 48)) return;
    fresh.follow();
    // Escape is the list's while one is open.
    const bool choosing = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId);
    const float side = 20 * em;
    ImGui::BeginChild("picture", {side + em, side + em});
    const glm::vec2 size(fresh.picture().width(), fresh.picture().height());
    if (size.x > 0) {
        const glm::vec2 shown = size * (side / std::max(size.x, size.y));
        ImGui::Image(panel_image(fresh.picture()), {shown.x, shown.y});
    }
    ImGui::EndChild();
    ImGui::SameLine();
    ImGui::BeginChild("wishes", {0, side + em});
    draw_wishes(context);
    const Parameters& wishes = fresh.wishes();
    const double spacing_m = wishes.number("terrain.spacing_m");
    ImGui::Spacing();
    ImGui::TextWrapped("%s",
                       fmt::format("{} × {} km, {} million samples. The lowest ground lies at 0 m; a sea "
                                   "level above it lets the sea in from the edges.",
                                   figure((wishes.whole("terrain.nx") - 1) * spacing_m / 1000, 4),
                                   figure((wishes.whole("terrain.ny") - 1) * spacing_m / 1000, 4),
                                   figure(1e-6 * wishes.whole("terrain.nx") * wishes.whole("terrain.ny"), 3))
                           .c_str());
    const std::string refusal = fresh.refusal();
    ImGui::PushTextWrapPos(0);
    if (!refusal.empty()) coloured_text(theme().warning, refusal);
    ImGui::PopTextWrapPos();
    ImGui::EndChild();
    bool ended = false;
    if (button("Generate", "as a scene of its own", refusal.empty())) {
        context.requests.open = fresh.request();
        ended = true;
    }
    ImGui::SameLine();
    if (button("Cancel new terrain") ||
        (!choosing && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))))
        ended = true;
    if (ended) {
        fresh.end();
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

}  // namespace talus::app

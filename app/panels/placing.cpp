#include <fmt/format.h>
#include <imgui.h>

#include "app/core/place_text.h"
#include "app/panels/panels.h"

namespace talus::app {

void place_button(PanelState& state, MarkKind kind, const char* words) {
    const bool placing = state.placing == kind;
    if (button(placing ? "Click on the map…" : words,
               "by the next click on the ground; its sign can be dragged while this panel is open")) {
        state.take_brush();
        if (!placing) state.placing = kind;
    }
}

void draw_button(PanelState& state, MapDrag what, const char* words, const char* tooltip) {
    const bool drawing = state.drawing == what;
    if (button(drawing ? "Drag over the ground…" : words, tooltip)) {
        state.take_brush();
        if (!drawing) state.drawing = what;
    }
}

std::optional<glm::dvec2> place_fields(PanelContext& context, const std::string& name, glm::dvec2 place_m) {
    const Grid& grid = context.session.grid();
    const float width = 0.5F * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
    auto& in_hand = context.state.numbers_in_hand;
    ImGui::SetNextItemWidth(width);
    const bool east = number_until_let_go(in_hand, name + " x", {"x %.2f m", 0, grid.width_m()}, place_m.x);
    ImGui::SameLine();
    ImGui::SetNextItemWidth(width);
    const bool north = number_until_let_go(in_hand, name + " y", {"y %.2f m", 0, grid.height_m()}, place_m.y);
    if (context.session.georeference())
        ImGui::TextDisabled("%s", file_coordinates_text(context.session, place_m).c_str());
    return east || north ? std::optional(place_m) : std::nullopt;
}

}  // namespace talus::app

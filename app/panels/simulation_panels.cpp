#include <imgui.h>

#include "app/panels/panels.h"
#include "render/view.h"

namespace talus::app {

void draw_simulation_panel(PanelContext& context) {
    heading("Time");
    draw_section(context.session, context.requests, "time");
    heading("Slopes (thermal erosion)");
    draw_section(context.session, context.requests, "thermal");
    heading("Memory of the history");
    draw_section(context.session, context.requests, "undo");
    heading("Autosave");
    draw_section(context.session, context.requests, "autosave");
}

void draw_water_panel(PanelContext& context) {
    draw_section(context.session, context.requests, "water");
    if (!context.session.wave_note().empty()) ImGui::TextWrapped("%s", context.session.wave_note().c_str());
}

void draw_erosion_panel(PanelContext& context) {
    draw_section(context.session, context.requests, "erosion");
    heading("Maps");
    draw_section(context.session, context.requests, "maps");
}

void draw_view_panel(PanelContext& context) {
    heading("Picture");
    const auto changes_picture =
        context.session.overflight() ? render::is_heeded_in_tiles : render::is_heeded;
    const bool draped = context.session.photo() || !context.session.scene().draping.picture.rgba.empty();
    std::vector<std::string> shown;
    for (std::string& name : names_in(context.session, "render"))
        if (changes_picture(name, context.session.view(), draped) ||
            (name == "render.tolerance_px" && context.session.surroundings()))
            shown.push_back(std::move(name));
    draw_parameters(context.session, context.requests, shown);
    if (has_backdrop_switch(context.session)) {
        heading("Around");
        draw_parameters(context.session, context.requests, {"tiles.backdrop"});
    }
    heading("Camera");
    draw_section(context.session, context.requests, "camera");
}

}  // namespace talus::app

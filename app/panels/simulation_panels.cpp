#include <imgui.h>
#include <imgui_stdlib.h>

#include <utility>

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
    draw_springs(context);
    heading("Water");
    draw_section(context.session, context.requests, "water");
    if (!context.session.wave_note().empty()) ImGui::TextWrapped("%s", context.session.wave_note().c_str());
}

namespace {

void draw_cameras(PanelContext& context) {
    heading("Kept cameras");
    PanelRequests& requests = context.requests;
    std::string& name = context.state.camera_name;
    const float room = ImGui::GetContentRegionAvail().x;
    ImGui::SetNextItemWidth(0.54F * room);
    const bool entered =
        ImGui::InputTextWithHint("##camera name", "a name", &name, ImGuiInputTextFlags_EnterReturnsTrue);
    note_widget("camera name");
    ImGui::SameLine();
    if ((button("Keep camera", "The view from here is saved with the project, by this name.",
                !name.empty()) ||
         entered) &&
        !name.empty())
        requests.acts.emplace_back([kept = std::exchange(name, "")](Session& s) { s.keep_camera(kept); });
    for (const NamedCamera& camera : context.session.cameras()) {
        ImGui::PushID(camera.name.c_str());
        if (ImGui::SmallButton("forget"))
            requests.acts.emplace_back([gone = camera.name](Session& s) { s.forget_camera(gone); });
        note_widget("forget camera " + camera.name);
        ImGui::SameLine();
        if (selectable_text(camera.name))
            requests.acts.emplace_back([wanted = camera.name](Session& s) { s.go_to_camera(wanted); });
        note_widget("camera " + camera.name);
        ImGui::PopID();
    }
}

}  // namespace

void draw_view_panel(PanelContext& context) {
    // A terrain in tiles has no document that would keep them.
    if (!context.state.only_looks) draw_cameras(context);
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
    std::vector<std::string> materials = names_in(context.session, "material");
    std::erase_if(materials, [&](const std::string& name) {
        return !changes_picture(name, context.session.view(), draped) ||
               (name == "material.masked" && !context.session.simulation().terrain().painted);
    });
    if (!materials.empty()) {
        heading("Materials");
        draw_parameters(context.session, context.requests, materials);
    }
    if (has_backdrop_switch(context.session)) {
        heading("Around");
        draw_parameters(context.session, context.requests, {"tiles.backdrop"});
    }
    heading("Camera");
    draw_section(context.session, context.requests, "camera");
}

}  // namespace talus::app

#include <fmt/format.h>
#include <imgui.h>

#include "app/panels/panels.h"
#include "app/tools/brush_stroke.h"

namespace talus {
namespace {

// The parameters that a tool listens to, beside size and how it fades.
std::vector<std::string> settings_of(const std::string& tool) {
    if (tool == "raise") return {"brush.rate_m_per_s", "brush.material"};
    if (tool == "lower" || tool == "water") return {"brush.rate_m_per_s"};
    if (tool == "height") return {"brush.height_m", "brush.blend_per_s"};
    if (tool == "ramp") return {};
    if (tool == "noise")
        return {"brush.rate_m_per_s", "noise.kind", "noise.wavelength_m", "noise.octaves",
                "noise.gain",         "noise.warp", "noise.seed"};
    if (tool == "terrace") return {"terrace.step_m", "terrace.flat", "brush.blend_per_s"};
    if (tool == "stamp")
        return {"stamp.mode", "stamp.relief_m", "stamp.zero", "stamp.turn_deg", "stamp.mirrored"};
    if (tool == "erode") return {"erode.acceleration", "erode.rain", "erode.speed"};
    if (tool == "rain") return {"brush.rain", "brush.blend_per_s"};
    if (tool == "hardness" || tool == "mask") return {"brush.value", "brush.blend_per_s"};
    return {"brush.blend_per_s"};
}

const char* how_to(const std::string& tool) {
    if (tool == "height") return "Ctrl and a click pick the height under the mouse.";
    if (tool == "ramp") return "Press where the slope begins, let go where it ends.";
    if (tool == "erode") return "Hold: rain gathers, carves and settles, under the brush alone.";
    if (tool == "water") return "Ctrl takes water away.";
    if (tool == "rain" || tool == "hardness" || tool == "mask") return "Ctrl wipes what was painted.";
    if (tool == "flatten") return "To the height where the stroke begins.";
    return "Ctrl turns it around, Shift smooths.";
}

std::string key_of(std::size_t tool) {
    if (tool < 9) return fmt::format("key {}", tool + 1);
    return fmt::format("keys Shift+{}", tool - 8);
}

void draw_stamp(PanelContext& context) {
    const Stamp* stamp = context.session.simulation().stamp();
    if (stamp)
        ImGui::TextWrapped("%s", fmt::format("{} × {} samples, {} × {} m, {} m high", stamp->grid.nx,
                                             stamp->grid.ny, figure(stamp->grid.width_m(), 4),
                                             figure(stamp->grid.height_m(), 4), figure(stamp->relief_m, 4))
                                     .c_str());
    else
        ImGui::TextWrapped("There is no stamp yet: take a file, or the ground under the brush.");
    if (button("From a file…", "a heightmap or picture whose heights become the stamp"))
        context.state.dialog.begin(FileDialog::Purpose::stamp, context.session.path());
    ImGui::SameLine();
    if (button("From here", "the ground under the brush's square around the middle of the picture"))
        context.requests.acts.emplace_back([](Session& s) {
            const glm::dvec3 middle = s.camera().target;
            const double radius = s.view().number("brush.radius_m");
            s.apply(ChooseStamp{
                {}, {middle.x - radius, middle.y - radius, middle.x + radius, middle.y + radius}, nullptr});
        });
}

}  // namespace

void draw_tools_panel(PanelContext& context) {
    Session& session = context.session;
    PanelRequests& requests = context.requests;
    const float spacing = ImGui::GetStyle().ItemSpacing.x;
    const float third = (ImGui::GetContentRegionAvail().x - 2 * spacing) / 3;
    if (choice_button(session.playing ? "Pause" : "Play", session.playing, "Space: runs the simulations",
                      third))
        requests.acts.emplace_back([](Session& s) { s.toggle_play(); });
    ImGui::SameLine();
    if (choice_button("Step", false, "the key . : one tick", third))
        requests.acts.emplace_back([](Session& s) { s.step(); });
    ImGui::SameLine();
    if (choice_button("Frame", false, "F: the whole terrain", third)) requests.framing = true;
    if (choice_button("Undo", false, "Ctrl+Z", third)) requests.undo = true;
    ImGui::SameLine();
    if (choice_button("Redo", false, "Ctrl+Shift+Z", third)) requests.redo = true;
    ImGui::SameLine();
    if (choice_button("Reset", false, "the scene from its start; the file or generator is read anew", third))
        requests.reset = true;
    heading("Brush");
    const std::string tool = session.view().choice("brush.tool");
    const std::vector<std::string>& tools = tool_names();
    for (std::size_t i = 0; i < tools.size(); ++i) {
        if (choice_button(tools[i], tool == tools[i], key_of(i), third)) session.set("brush.tool", tools[i]);
        if (i % 3 != 2 && i + 1 < tools.size()) ImGui::SameLine();
    }
    ImGui::PushTextWrapPos(0);
    ImGui::TextDisabled("%s", how_to(tool));
    ImGui::PopTextWrapPos();
    ImGui::Spacing();
    draw_parameters(session, requests, {"brush.radius_m"});
    draw_parameters(session, requests, settings_of(tool));
    if (tool == "stamp") draw_stamp(context);
    draw_parameters(session, requests, {"brush.falloff", "brush.curve", "brush.spacing", "brush.jitter"});
    if (session.view().number("brush.jitter") > 0) draw_parameters(session, requests, {"brush.seed"});
    if (tool != "mask") draw_parameters(session, requests, {"brush.over"});
}

}  // namespace talus

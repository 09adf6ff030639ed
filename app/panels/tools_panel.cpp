#include <fmt/format.h>
#include <imgui.h>

#include "app/panels/panels.h"
#include "app/tools/tools.h"

namespace talus::app {
namespace {

std::string key_of(std::size_t tool) {
    if (tool < 9) return fmt::format("key {}", tool + 1);
    return fmt::format("keys Shift+{}", tool - 8);
}

void draw_stamp(PanelContext& context) {
    const Stamp* stamp = context.session.simulation().stamp().get();
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
    const Tool& tool = tool_named(session.view().choice("brush.tool"));
    for (std::size_t i = 0; i < tools().size(); ++i) {
        const std::string& name = tools()[i].name;
        if (choice_button(name, tool.name == name, key_of(i), third)) {
            session.set("brush.tool", name);
            context.state.take_brush();
        }
        if (i % 3 != 2 && i + 1 < tools().size()) ImGui::SameLine();
    }
    ImGui::PushTextWrapPos(0);
    ImGui::TextDisabled("%s", tool.how_to.c_str());
    ImGui::PopTextWrapPos();
    ImGui::Spacing();
    draw_parameters(session, requests, {"brush.radius_m"});
    draw_parameters(session, requests, tool.settings);
    if (tool.course == StrokeCourse::stamps) draw_stamp(context);
    draw_parameters(session, requests, {"brush.falloff", "brush.curve", "brush.spacing", "brush.jitter"});
    if (session.view().number("brush.jitter") > 0) draw_parameters(session, requests, {"brush.seed"});
    if (tool.limited_by_mask) draw_parameters(session, requests, {"brush.over"});
}

}  // namespace talus::app

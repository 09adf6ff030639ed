#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/core/small_picture.h"
#include "app/core/sources.h"
#include "app/panels/panels.h"
#include "app/tools/tools.h"
#include "sim/terrain/stamp_shapes.h"

namespace talus::app {
namespace {

std::string key_of(std::size_t tool) {
    if (tool < 9) return fmt::format("key {}", tool + 1);
    return fmt::format("keys Shift+{}", tool - 8);
}

// From above.
const gpu::Texture& thumbnail(PanelState& state, const StampShape& shape) {
    gpu::Texture& texture = state.thumbnails["stamp " + shape.name];
    if (texture.width() > 0) return texture;
    const Stamp stamp = shaped_stamp(shape.name);
    std::vector<float> heights_m(stamp.heights.size());
    std::transform(stamp.heights.begin(), stamp.heights.end(), heights_m.begin(),
                   [&](float height) { return static_cast<float>(height * stamp.relief_m); });
    constexpr glm::ivec2 size(96, 96);
    const std::vector<std::uint8_t> picture = small_picture(stamp.grid, heights_m, {}, size);
    texture = gpu::Texture("stamp", gpu::Format::rgba8, size.x, size.y);
    texture.write(texture.whole(), std::as_bytes(std::span(picture)));
    return texture;
}

// Stamps that Talus makes, and those of the person's own folder.
void draw_shelf(PanelContext& context) {
    const std::size_t a_row = stamp_shapes().size();
    const float spacing = ImGui::GetStyle().ItemSpacing.x / 2;
    const float side = (ImGui::GetContentRegionAvail().x - static_cast<float>(a_row - 1) * spacing) /
                           static_cast<float>(a_row) -
                       2 * ImGui::GetStyle().FramePadding.x;
    for (const StampShape& shape : stamp_shapes()) {
        ImGui::PushID(shape.name.c_str());
        if (ImGui::ImageButton(panel_image(thumbnail(context.state, shape)), {side, side}))
            context.requests.acts.emplace_back([&shape](Session& s) {
                const ChooseStamp choose = shelf_stamp(shape.name);
                // As high as it is wide in proportion.
                s.unset("stamp.relief_m");
                s.apply_together(name_of(choose), {choose});
            });
        note_widget("stamp " + shape.name);
        tooltip_of(label_of_name(shape.name) + ": " + shape.what);
        ImGui::PopID();
        if (&shape != &stamp_shapes().back()) ImGui::SameLine(0, spacing);
    }
    context.state.own_stamps.follow();
    const std::vector<std::string>& own = context.state.own_stamps.files();
    ImGui::SetNextItemWidth(-1);
    const bool open = ImGui::BeginCombo("##own stamps", "Own stamps");
    note_widget("own stamps");
    if (!open) return;
    close_on_escape();
    const std::string folder = StampFolder::path().string();
    if (own.empty()) ImGui::TextWrapped("Heightmaps in %s stand here.", folder.c_str());
    for (const std::string& file : own) {
        if (selectable_text(file)) context.requests.stamp = (StampFolder::path() / file).string();
        note_widget("own stamp " + file);
    }
    ImGui::EndCombo();
}

void draw_stamp(PanelContext& context) {
    const Stamp* stamp = context.session.simulation().stamp().get();
    draw_shelf(context);
    if (stamp)
        ImGui::TextWrapped("%s", fmt::format("{} × {} samples, {} × {} m, {} m high", stamp->grid.nx,
                                             stamp->grid.ny, figure(stamp->grid.width_m(), 4),
                                             figure(stamp->grid.height_m(), 4), figure(stamp->relief_m, 4))
                                     .c_str());
    else
        ImGui::TextWrapped("There is no stamp yet: take one above, a file, or the ground under the brush.");
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
    const float spacing = ImGui::GetStyle().ItemSpacing.x / 2;
    const float half = (ImGui::GetContentRegionAvail().x - spacing) / 2;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {spacing, ImGui::GetStyle().ItemSpacing.y});
    if (icon_button(session.playing ? "Pause" : "Play", "Space: runs the simulations",
                    {session.playing ? "5,2 5,14; 11,2 11,14" : "4,2 13,8 4,14 4,2", half, session.playing,
                     true, "play"}))
        requests.acts.emplace_back([plays = !session.playing](Session& s) { s.set_playing(plays); });
    ImGui::SameLine();
    if (icon_button("Step", "the key . : one tick", {"3,2 10,8 3,14 3,2; 13,2 13,14", half}))
        requests.acts.emplace_back([](Session& s) { s.begin_step(); });
    const Undo& history = session.simulation().undo_history();
    if (icon_button("Undo", history.can_undo() ? "Ctrl+Z: " + history.undo_name() : "Ctrl+Z",
                    {"6,3 2,7 6,11; 2,7 11,7 14,9 14,13", half, false,
                     history.can_undo() || session.playing || session.mid_tick()}))
        requests.undo = true;
    ImGui::SameLine();
    if (icon_button("Redo", history.can_redo() ? "Ctrl+Shift+Z: " + history.redo_name() : "Ctrl+Shift+Z",
                    {"10,3 14,7 10,11; 14,7 5,7 2,9 2,13", half, false, history.can_redo()}))
        requests.redo = true;
    if (icon_button("Fit view", "F: the camera sees the whole terrain",
                    {"1,5 1,1 5,1; 11,1 15,1 15,5; 15,11 15,15 11,15; 5,15 1,15 1,11", half}))
        requests.framing = true;
    ImGui::SameLine();
    if (icon_button("Top view", "T: straight down, as on a map; again: back",
                    {"2,2 14,2 14,14 2,14 2,2; 8,12 8,4; 5,7 8,4 11,7", half, is_from_top(session)}))
        toggle_top_view(session, context.state);
    if (icon_button("Start over", "the scene from its start; the file or generator is read anew",
                    {"13,8 12,12 8,14 4,12 2,8 4,4 8,2 12,4; 12,1 12,5 8,5", half}))
        requests.reset = true;
    ImGui::SameLine();
    const std::string& recording = context.state.recording;
    const bool films = !recording.empty();
    if (icon_button(films ? "End film" : "Record", "F9: a film of the view, beside the project; needs ffmpeg",
                    {films ? "3,3 13,3 13,13 3,13 3,3" : "8,3 11,4 13,8 11,12 8,13 5,12 3,8 5,4 8,3", half,
                     films, true, "record"}))
        requests.record = true;
    if (films) text_line(recording);
    heading("Brush");
    const Tool& tool = tool_named(session.view().choice("brush.tool"));
    for (std::size_t i = 0; i < tools().size(); ++i) {
        const std::string& name = tools()[i].name;
        if (icon_button(name, key_of(i), {tools()[i].icon, half, tool.name == name})) {
            session.set("brush.tool", name);
            context.state.take_brush();
        }
        if (i % 2 == 0 && i + 1 < tools().size()) ImGui::SameLine();
    }
    ImGui::PopStyleVar();
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

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <string>
#include <vector>

#include "app/panels/panels.h"

namespace talus::app {
namespace {

std::vector<std::string> parameters_of(PathKind kind) {
    switch (kind) {
        case PathKind::road:
            return {"path.width_m", "path.side_slope", "path.grade_percent", "path.material", "brush.over"};
        case PathKind::river:
            return {"path.width_m", "path.side_slope", "path.depth_m", "path.fall_m_per_km", "brush.over"};
        case PathKind::wall:
            return {"path.width_m", "path.side_slope", "path.height_m", "path.material", "brush.over"};
        default:
            return {"path.width_m", "path.side_slope", "path.depth_m", "brush.over"};
    }
}

void draw_warnings(const PathDesign& design, const PathWishes& wishes, const Grid& grid) {
    if (design.misses_m > 0.1)
        ImGui::TextWrapped("%s",
                           fmt::format("At this grade the way is too short for the climb: its ends miss the "
                                       "ground by {} m. Give it bends.",
                                       figure(design.misses_m, 3))
                               .c_str());
    if (wishes.kind == PathKind::river && design.ground_m.back() > design.ground_m.front())
        ImGui::TextWrapped(
            "The last point lies higher than the first: water runs from the first to the last.");
    if (!design.sides_meet)
        ImGui::TextWrapped("The ground is steeper than the sides in places: they end in a step there.");
    if (wishes.width_m < 2 * std::max(grid.dx, grid.dy))
        ImGui::TextWrapped("It is narrower than two samples of the terrain, and will have gaps.");
}

void draw_design(const PathDesign& design) {
    figure_line("length", fmt::format("{} m", figure(design.length_m, 4)));
    figure_line("steepest", fmt::format("{} %", figure(100 * design.steepest, 3)));
    if (design.path.cuts) figure_line("deepest cut", fmt::format("{} m", figure(design.deepest_cut_m, 3)));
    if (design.path.fills) figure_line("highest fill", fmt::format("{} m", figure(design.highest_fill_m, 3)));
}

}  // namespace

void draw_paths_panel(PanelContext& context) {
    const Session& session = context.session;
    const PathDraft& draft = session.path_draft();
    bool& drawing = context.state.drawing_path;
    ImGui::TextWrapped(
        "A path goes smoothly through points on the ground. They can be moved until it is built, and after "
        "undo.");
    draw_parameters(session, context.requests, {"path.kind"});
    const PathWishes wishes = path_wishes(session.view());
    draw_parameters(session, context.requests, parameters_of(wishes.kind));
    heading("Points");
    if (choice_button("Draw it", drawing, "clicks on the ground put points, drags move them; Escape ends it",
                      -1)) {
        const bool begins = !drawing;
        context.state.take_brush();
        drawing = begins;
    }
    const std::size_t count = draft.points_m().size();
    figure_line("points", fmt::format("{}", count));
    note_widget(fmt::format("path of {} points", count));
    if (button("Remove the last", "the key Backspace while it is drawn", count > 0))
        context.requests.acts.emplace_back([](Session& s) { s.path_draft().remove_last(); });
    ImGui::SameLine();
    if (button("Remove all", "what was built stays", count > 0))
        context.requests.acts.emplace_back([](Session& s) { s.path_draft().clear(); });
    if (button("Turn round", "the last point becomes the first", count > 1))
        context.requests.acts.emplace_back([](Session& s) { s.path_draft().turn_round(); });
    if (draft.design()) {
        draw_design(*draft.design());
        note_widget(fmt::format("path no steeper than {:.2f} %", 100 * draft.design()->steepest + 0.005));
        draw_warnings(*draft.design(), wishes, session.grid());
    }
    if (button("Build it", "the key Enter while it is drawn; undo takes the whole path back", count >= 2))
        context.requests.acts.emplace_back([](Session& s) { s.build_path(); });
}

}  // namespace talus::app

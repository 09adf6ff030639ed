#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "app/panels/panels.h"
#include "app/panels/style.h"

namespace talus::app {
namespace {

struct SidePanel {
    const char* name;
    const char* what;
    void (*draw)(PanelContext&);
    bool only_looks = false;  ///< it is there too where the terrain can be looked at and not changed
    bool (*is_there)(const Session&) = nullptr;  ///< null: always
};
constexpr std::array<SidePanel, 15> side_panels = {{
    {"Simulation", "time, and slopes that slide", draw_simulation_panel},
    {"Water", "rain, sea, edges, waves", draw_water_panel},
    {"Erosion", "what water takes, carries and lays down", draw_erosion_panel},
    {"Tables", "numbers that follow tables, rasters, events", draw_tables_panel},
    {"View", "what the colours show, sun, camera", draw_view_panel, true},
    {"Mask", "where brushes and simulations act", draw_mask_panel},
    {"Paths", "roads, rivers, walls and ditches along a line of points", draw_paths_panel},
    {"Map", "size, place, heights and noise of the whole map", draw_map_panel},
    {"Cut out", "a part of a large terrain, to work in", draw_cut_out_panel, true, has_cut_out_panel},
    {"History", "what was done; back and forth", draw_history_panel},
    {"Ledger", "where all rock and water is", draw_ledger_panel},
    {"Gauges", "the water at a place, and through a line, against time", draw_gauges_panel},
    {"Profiler", "what takes how long", draw_profiler_panel, true},
    {"Presets", "scenes to start from", draw_presets_panel, true},
    {"Log", "what was said", draw_log_panel, true},
}};

float menu_height() {
    return em(1) + 2 * ImGui::GetStyle().FramePadding.y;
}

constexpr float least_tools_em = 15;
constexpr float least_side_em = 17;
constexpr float most_em = 60;
constexpr float folded_em = 1.7F;
// A picture narrower than that is none to work in.
constexpr float least_picture_em = 10;

// Whether the window has no room for the tools beside the other panels: then they are one of them.
bool is_narrow(glm::ivec2 size) {
    return static_cast<float>(size.x) < em(least_tools_em + least_side_em + least_picture_em);
}

// Widths of the panels on both sides, pixels: as they were dragged, as far as the picture keeps its room.
glm::vec2 side_widths(const PanelState& state, glm::ivec2 size) {
    if (!state.panels_shown) return {0, 0};
    const float room = static_cast<float>(size.x) / em(1);
    const auto width = [](const PanelSide& side, float least) {
        return side.folded ? folded_em : std::clamp(side.width_em, least, most_em);
    };
    float tools = state.only_looks || is_narrow(size) ? 0 : width(state.tools_side, least_tools_em);
    float panels = width(state.panels_side, least_side_em);
    const float most_panels = std::max(room - tools - least_picture_em, least_side_em);
    if (!state.panels_side.folded) panels = std::min({panels, most_panels, room});
    if (tools > 0 && !state.tools_side.folded)
        tools = std::min(tools, std::max(room - panels - least_picture_em, least_tools_em));
    // Whole pixels, as windows have: else each frame would take a part of one away.
    return {std::round(em(tools)), std::round(em(panels))};
}

// A window that fills the height between menu and status line, at one of the sides. Its inner edge can be
// dragged. False: it is folded to a button that brings it back, and ends at once.
bool begin_side(const char* name, bool right, float width, float most, PanelSide& side, glm::ivec2 size) {
    const auto w = static_cast<float>(size.x);
    const float height = static_cast<float>(size.y) - menu_height() - status_height();
    ImGui::SetNextWindowPos({right ? w - width : 0, menu_height()});
    ImGui::SetNextWindowSize({width, height});
    // Where the window is narrower than they should be, they are as it is.
    const float least = std::min(em(right ? least_side_em : least_tools_em), width);
    ImGui::SetNextWindowSizeConstraints({least, height}, {std::max(width, most), height});
    int flags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                ImGuiWindowFlags_NoBringToFrontOnFocus;
    if (side.folded) {
        flags |= ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoScrollbar;
        ImGui::SetNextWindowSizeConstraints({width, height}, {width, height});
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, ImGui::GetStyle().WindowPadding.y});
        ImGui::Begin(name, nullptr, flags);
        ImGui::PopStyleVar();
        if (ImGui::Button(right ? "«" : "»", {width, 0})) side.folded = false;
        note_widget(std::string("unfold ") + name);
        tooltip_of(std::string("brings back: ") + name);
        return false;
    }
    // Edges are enough to drag: corners show no grips.
    for (const int grip : {ImGuiCol_ResizeGrip, ImGuiCol_ResizeGripHovered, ImGuiCol_ResizeGripActive})
        ImGui::PushStyleColor(grip, 0);
    ImGui::Begin(name, nullptr, flags);
    ImGui::PopStyleColor(3);
    if (const float dragged = ImGui::GetWindowWidth(); dragged != width) side.width_em = dragged / em(1);
    return true;
}

void draw_side(PanelContext& context, bool with_tools) {
    PanelState& state = context.state;
    // Where the tools have a side of their own they are no panel of this one.
    constexpr const char* tools = "Tools";
    if (!with_tools && !state.only_looks && state.shown == tools) state.shown = side_panels.front().name;
    std::vector<const SidePanel*> panels;
    for (const SidePanel& panel : side_panels)
        if ((panel.only_looks || !state.only_looks) && (!panel.is_there || panel.is_there(context.session)))
            panels.push_back(&panel);
    // What a person chose is kept for a terrain that has it.
    const bool is_there = std::any_of(panels.begin(), panels.end(),
                                      [&](const SidePanel* panel) { return panel->name == state.shown; });
    const std::string shown = is_there || (with_tools && state.shown == tools) ? state.shown : "View";
    const float spacing = ImGui::GetStyle().ItemSpacing.x / 2;
    // As many in a row as their names leave room for.
    const float room = ImGui::GetContentRegionAvail().x;
    const auto columns = static_cast<std::size_t>(std::clamp(room / em(5.4F), 1.0F, 8.0F));
    const float width = (room - static_cast<float>(columns - 1) * spacing) / static_cast<float>(columns);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {spacing, spacing});
    for (std::size_t i = 0; i < panels.size(); ++i) {
        if (i % columns != 0) ImGui::SameLine();
        if (choice_button(panels[i]->name, shown == panels[i]->name, panels[i]->what, width))
            state.shown = panels[i]->name;
    }
    if (with_tools && panels.size() % columns != 0) ImGui::SameLine();
    if (with_tools && choice_button(tools, shown == tools, "the brush and its tools", width))
        state.shown = tools;
    ImGui::PopStyleVar();
    ImGui::Separator();
    // Keys move into it as if it were no window of its own.
    ImGui::BeginChild("side", {0, 0}, false, ImGuiWindowFlags_NavFlattened);
    for (const SidePanel& panel : side_panels)
        if (shown == panel.name) panel.draw(context);
    if (shown == tools) draw_tools_panel(context);
    ImGui::EndChild();
}

}  // namespace

std::vector<std::string> panel_names() {
    std::vector<std::string> names;
    std::transform(side_panels.begin(), side_panels.end(), std::back_inserter(names),
                   [](const SidePanel& panel) { return panel.name; });
    return names;
}

PictureArea picture_area(const PanelState& state, glm::ivec2 size) {
    const auto pixels = [](float length) { return static_cast<int>(std::ceil(length)); };
    const glm::vec2 sides = side_widths(state, size);
    const int left = pixels(sides.x);
    const int right = pixels(sides.y);
    const int top = pixels(menu_height());
    const int bottom = pixels(status_height());
    return {{left, top}, glm::max(size - glm::ivec2(left + right, top + bottom), 16)};
}

namespace {

// Arrow keys move from widget to widget of one of the sides, from the next frame on.
void follow_keyboard(PanelState& state, bool has_tools) {
    if (state.keyboard_in == KeyboardIn::tools && !has_tools) state.keyboard_in = KeyboardIn::panels;
    if (!state.panels_shown) state.keyboard_in = KeyboardIn::picture;
    ImGuiIO& io = ImGui::GetIO();
    const bool moves = state.keyboard_in != KeyboardIn::picture;
    if (moves)
        io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    else
        io.ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
    if (std::exchange(state.keyboard_was_in, state.keyboard_in) == state.keyboard_in) return;
    ImGui::SetWindowFocus(state.keyboard_in == KeyboardIn::tools ? "Tools" : moves ? "Panels" : nullptr);
}

}  // namespace

void draw_panels(PanelContext& context, const StatusFigures& figures, glm::ivec2 size) {
    begin_widgets();
    follow_keyboard(context.state, side_widths(context.state, size).x > 0);
    if (ImGui::BeginMainMenuBar()) {
        draw_menu(context);
        ImGui::EndMainMenuBar();
    }
    if (context.state.panels_shown) {
        const glm::vec2 sides = side_widths(context.state, size);
        const float most = static_cast<float>(size.x) - em(least_picture_em);
        if (sides.x > 0) {
            if (begin_side("Tools", false, sides.x, most - sides.y, context.state.tools_side, size))
                draw_tools_panel(context);
            ImGui::End();
        }
        if (begin_side("Panels", true, sides.y, most - sides.x, context.state.panels_side, size))
            draw_side(context, is_narrow(size) && !context.state.only_looks);
        ImGui::End();
    }
    if (context.state.start_page) draw_start_page(context, size);
    // One dialog at a time: two would replace each other every frame.
    if (context.state.question)
        draw_question(context);
    else if (context.state.self_check)
        draw_self_check_dialog(context);
    else if (!context.state.import.path.empty())
        draw_import_dialog(context);
    else if (context.state.fresh.is_shown())
        draw_new_dialog(context);
    else if (context.state.keys_shown)
        draw_keys_dialog(context);
    else if (context.state.write.shown && context.state.dialog.purpose != FileDialog::Purpose::export_to)
        draw_export_dialog(context);
    else
        draw_file_dialog(context);
    draw_status_line(context.session, figures, size.x, size.y);
    draw_notice(figures.message, picture_area(context.state, size));
}

}  // namespace talus::app

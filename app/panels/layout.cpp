#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

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

// Before the first frame too.
float em(float times) {
    return times * ImGui::GetIO().Fonts->ConfigData[0].SizePixels;
}
float menu_height() {
    return em(1) + 2 * ImGui::GetStyle().FramePadding.y;
}
float status_height() {
    return em(1) + 8;
}

constexpr float tools_width_em = 17;
constexpr float side_width_em = 23;
// A picture narrower than that is none to work in.
constexpr float least_picture_em = 10;

// Whether the window has no room for the tools beside the other panels: then they are one of them.
bool is_narrow(glm::ivec2 size) {
    return static_cast<float>(size.x) < em(tools_width_em + side_width_em + least_picture_em);
}

// Widths of the panels on both sides, pixels.
glm::vec2 side_widths(const PanelState& state, glm::ivec2 size) {
    if (!state.panels_shown) return {0, 0};
    if (state.only_looks) return {0, std::min(em(side_width_em), static_cast<float>(size.x))};
    if (!is_narrow(size)) return {em(tools_width_em), em(side_width_em)};
    return {0, std::min(em(side_width_em), static_cast<float>(size.x))};
}

// A window that fills the height between menu and status line, at one of the sides.
bool begin_side(const char* name, bool right, float width, glm::ivec2 size) {
    const auto w = static_cast<float>(size.x);
    const float height = static_cast<float>(size.y) - menu_height() - status_height();
    ImGui::SetNextWindowPos({right ? w - width : 0, menu_height()});
    ImGui::SetNextWindowSize({width, height});
    return ImGui::Begin(name, nullptr,
                        ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                            ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus);
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
    const float width = (ImGui::GetContentRegionAvail().x - 3 * spacing) / 4;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {spacing, spacing});
    for (std::size_t i = 0; i < panels.size(); ++i) {
        if (i % 4 != 0) ImGui::SameLine();
        if (choice_button(panels[i]->name, shown == panels[i]->name, panels[i]->what, width))
            state.shown = panels[i]->name;
    }
    if (with_tools && choice_button(tools, shown == tools, "the brush and its tools", width))
        state.shown = tools;
    ImGui::PopStyleVar();
    ImGui::Separator();
    ImGui::BeginChild("side");
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

void draw_panels(PanelContext& context, const StatusFigures& figures, glm::ivec2 size) {
    begin_widgets();
    if (ImGui::BeginMainMenuBar()) {
        draw_menu(context);
        ImGui::EndMainMenuBar();
    }
    if (context.state.panels_shown) {
        const glm::vec2 sides = side_widths(context.state, size);
        if (sides.x > 0) {
            if (begin_side("Tools", false, sides.x, size)) draw_tools_panel(context);
            ImGui::End();
        }
        if (begin_side("Panels", true, sides.y, size))
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
    else if (context.state.write.shown)
        draw_export_dialog(context);
    else
        draw_file_dialog(context);
    draw_status_line(context.session, figures, size.x, size.y);
    draw_notice(figures.message, picture_area(context.state, size));
}

// At the upper edge of the picture: at the lower one are its legends.
void draw_notice(const std::string& message, const PictureArea& area) {
    if (message.empty()) return;
    // What does not fit into a line goes on in the next.
    const float room = std::clamp(static_cast<float>(area.size.x) - em(2), em(12), em(60));
    const ImVec2 text_size = ImGui::CalcTextSize(message.c_str(), nullptr, false, room);
    const float middle = static_cast<float>(area.corner.x) + static_cast<float>(area.size.x) / 2;
    const float left = std::max(middle - text_size.x / 2, 10.0F);
    const float top = static_cast<float>(area.corner.y) + em(0.8F);
    ImDrawList* list = ImGui::GetForegroundDrawList();
    list->AddRectFilled({left - 10, top - 5}, {left + text_size.x + 10, top + text_size.y + 5},
                        colour_of(theme().notice), 4);
    list->AddText(nullptr, 0, {left, top}, colour_of(theme().text), message.c_str(), nullptr, room);
}

// A height without -0.0.
std::string height_text(double height_m) {
    return fmt::format("{:.1f}", std::round(height_m * 10) / 10 + 0.0);
}

// Where the mouse is on the ground, in the file's coordinates where there are any.
std::string cursor_text(const Session& session, const std::optional<glm::dvec3>& cursor) {
    if (!cursor) return "–";
    const std::optional<Georeference> on_earth = session.georeference();
    const glm::dvec2 place =
        on_earth ? coordinates_of(*on_earth, session.grid(), glm::dvec2(*cursor)) : glm::dvec2(*cursor);
    // Degrees need more digits than metres: a tenth of a sample at least.
    const double step = on_earth ? std::abs(on_earth->transform[1]) : 1;
    const int digits = std::clamp(static_cast<int>(std::ceil(1 - std::log10(std::max(step, 1e-9)))), 1, 9);
    return fmt::format("{}{:.{}f}, {:.{}f}: {} m", on_earth ? "" : "x, y ", place.x, digits, place.y, digits,
                       height_text(cursor->z));
}

std::string status_text(const Session& session, const StatusFigures& figures) {
    const Grid& grid = session.grid();
    const glm::dvec2 heights_m = session.heights_m();
    std::string text = fmt::format("{} × {} samples, {} × {} m  |  {} to {} m  |  {}  |  ", grid.nx, grid.ny,
                                   figure(grid.dx, 4), figure(grid.dy, 4), height_text(heights_m.x),
                                   height_text(heights_m.y), cursor_text(session, figures.cursor));
    if (const Overflight* overflight = session.overflight())
        text += fmt::format("{}  |  ", overflight->tiles().state());
    else
        text += fmt::format("{:.2f} s, speed {} of {}  |  tick {:.1f} ms, ",
                            session.simulation().clock().simulated_s, figure(session.speed_reached(), 3),
                            figure(session.view().number("time.speed"), 3), session.tick_ms());
    if (const Surroundings* around = session.surroundings()) {
        if (!around->tiles().terrain().is_measured) text += "a sketch around it, ";
        if (around->tiles().awaited_tiles() > 0)
            text += fmt::format("{} tiles on their way, ", around->tiles().awaited_tiles());
    }
    const std::string photo = session.photo() ? session.photo()->state() : "";
    if (!photo.empty()) text += photo + ", ";
    return text + fmt::format("frame {:.1f} ms at {:.0f} %  |  {}", figures.frame_ms, 100 * figures.scale,
                              figures.device);
}

void draw_status_line(const Session& session, const StatusFigures& figures, int width, int height) {
    ImDrawList* list = ImGui::GetForegroundDrawList();
    const float line = status_height();
    const auto w = static_cast<float>(width);
    const auto h = static_cast<float>(height);
    const std::string text = shortened(status_text(session, figures), [&](const std::string& some) {
        return ImGui::CalcTextSize(some.c_str()).x <= w - 16;
    });
    list->AddRectFilled({0, h - line}, {w, h}, colour_of(theme().bar));
    list->AddText({8, h - line + 4}, colour_of(theme().text), text.c_str());
}

}  // namespace talus::app

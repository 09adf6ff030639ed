#include <fmt/format.h>
#include <imgui.h>

#include "app/panels/panels.h"

namespace talus {
namespace {

void draw_menu(Session& session, FileDialog& dialog, PanelRequests& requests) {
    if (!ImGui::BeginMenuBar()) return;
    if (ImGui::BeginMenu("File")) {
        if (ImGui::MenuItem("Open…", "Ctrl+O")) dialog.begin(FileDialog::Purpose::open, session.path());
        if (ImGui::MenuItem("Save", "Ctrl+S", false, !session.path().empty())) requests.save = session.path();
        if (ImGui::MenuItem("Save as…", "Ctrl+Shift+S"))
            dialog.begin(FileDialog::Purpose::save, session.path());
        ImGui::Separator();
        if (ImGui::MenuItem("Quit", "Ctrl+Q")) requests.quit = true;
        ImGui::EndMenu();
    }
    if (ImGui::BeginMenu("Edit")) {
        const Undo& history = session.simulation().undo_history();
        const std::string undo = history.can_undo() ? "Undo " + history.undo_name() : "Undo";
        const std::string redo = history.can_redo() ? "Redo " + history.redo_name() : "Redo";
        if (ImGui::MenuItem(undo.c_str(), "Ctrl+Z", false, history.can_undo())) requests.undo = true;
        if (ImGui::MenuItem(redo.c_str(), "Ctrl+Shift+Z", false, history.can_redo())) requests.redo = true;
        ImGui::EndMenu();
    }
    if (ImGui::BeginMenu("View")) {
        if (ImGui::MenuItem("Whole terrain", "F")) requests.framing = true;
        if (ImGui::MenuItem("Save a picture", "F12")) requests.picture = true;
        ImGui::Separator();
        for (const std::string& name : view_names())
            if (ImGui::MenuItem(name.c_str(), nullptr, session.view().choice("render.view") == name))
                session.set("render.view", name);
        ImGui::EndMenu();
    }
    ImGui::EndMenuBar();
}

void draw_section(const Session& session, const std::string& section, const Parameters& parameters,
                  PanelRequests& requests) {
    for (const Parameter& p : parameters.declared()) {
        if (!p.name.starts_with(section + ".")) continue;
        Value value = session.value(p.name);
        if (draw_parameter(p, value))
            requests.acts.emplace_back([name = p.name, value](Session& s) { s.set(name, value); });
    }
}

}  // namespace

void draw_main_panel(Session& session, FileDialog& dialog, bool& placing_gauge, PanelRequests& requests) {
    ImGui::SetNextWindowPos({10, 10}, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSize({330, 600}, ImGuiCond_FirstUseEver);
    if (!ImGui::Begin("Talus", nullptr, ImGuiWindowFlags_MenuBar)) {
        ImGui::End();
        return;
    }
    draw_menu(session, dialog, requests);
    ImGui::TextUnformatted(session.scene().title.c_str());
    if (ImGui::Button(session.playing ? "Pause" : "Play", {70, 0}))
        requests.acts.emplace_back([](Session& s) { s.toggle_play(); });
    ImGui::SameLine();
    if (ImGui::Button("Step")) requests.acts.emplace_back([](Session& s) { s.step(); });
    ImGui::SameLine();
    if (ImGui::Button("Undo")) requests.undo = true;
    ImGui::SameLine();
    if (ImGui::Button("Redo")) requests.redo = true;
    ImGui::SameLine();
    if (ImGui::Button("Reset")) requests.reset = true;
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("the scene from its start; the file or generator is read anew");

    const std::string mode = session.view().choice("brush.mode");
    for (const std::string& name : session.view().declaration("brush.mode").choices) {
        if (ImGui::RadioButton(name.c_str(), mode == name)) session.set("brush.mode", name);
        ImGui::SameLine();
    }
    ImGui::NewLine();
    ImGui::PushItemWidth(170);
    const Parameters& simulated = session.simulation().parameters();
    const struct {
        const char* title;
        const char* section;
        const Parameters& parameters;
        bool open;
    } sections[] = {{"Brush", "brush", session.view(), true},
                    {"Water", "water", simulated, false},
                    {"Erosion by water", "erosion", simulated, false},
                    {"Thermal erosion", "thermal", simulated, false},
                    {"Time", "time", session.view(), true},
                    {"Picture", "render", session.view(), false},
                    {"Camera", "camera", session.view(), false},
                    {"Generated terrain", "terrain", simulated, false},
                    {"Undo", "undo", session.view(), false}};
    for (const auto& s : sections) {
        if (!ImGui::CollapsingHeader(s.title, s.open ? ImGuiTreeNodeFlags_DefaultOpen : 0)) continue;
        draw_section(session, s.section, s.parameters, requests);
        if (std::string(s.section) == "time") draw_section(session, "time", simulated, requests);
        if (std::string(s.section) == "water" && !session.wave_note().empty())
            ImGui::TextWrapped("%s", session.wave_note().c_str());
        if (std::string(s.section) == "terrain")
            ImGui::TextWrapped("Save the scene as a preset, or use --set, to generate anew with these.");
    }
    if (ImGui::CollapsingHeader("Ledger")) draw_ledger_panel(session, requests);
    if (ImGui::CollapsingHeader("Gauges")) draw_gauges_panel(session, placing_gauge, requests);
    ImGui::PopItemWidth();
    ImGui::End();
}

void draw_status_line(const Session& session, const StatusFigures& figures, int width, int height) {
    const Grid& grid = session.grid();
    std::string text = fmt::format("{} × {} samples, {:.4g} × {:.4g} m", grid.nx, grid.ny, grid.dx, grid.dy);
    text += figures.cursor_height_m ? fmt::format("  |  height {:.1f} m", *figures.cursor_height_m)
                                    : "  |  height –";
    text += fmt::format("  |  {:.2f} s, speed {:.3g} of {:.3g}", session.simulation().clock().simulated_s,
                        session.speed_reached(), std::get<double>(session.value("time.speed")));
    text += fmt::format("  |  tick {:.1f} ms, frame {:.1f} ms at {:.0f} %  |  {}", session.tick_ms(),
                        figures.frame_ms, 100 * figures.scale, figures.device);
    ImDrawList* list = ImGui::GetForegroundDrawList();
    const float line = ImGui::GetFontSize() + 8;
    const auto w = static_cast<float>(width);
    const auto h = static_cast<float>(height);
    list->AddRectFilled({0, h - line}, {w, h}, IM_COL32(18, 20, 24, 235));
    list->AddText({8, h - line + 4}, IM_COL32(225, 228, 232, 255), text.c_str());
    if (figures.message.empty()) return;
    const float text_width = ImGui::CalcTextSize(figures.message.c_str()).x;
    list->AddRectFilled({(w - text_width) / 2 - 10, h - 2 * line - 6},
                        {(w + text_width) / 2 + 10, h - line - 4}, IM_COL32(70, 50, 20, 240), 4);
    list->AddText({(w - text_width) / 2, h - 2 * line - 2}, IM_COL32_WHITE, figures.message.c_str());
}

}  // namespace talus

#include <imgui.h>

#include "app/core/part.h"
#include "app/core/scene_file.h"
#include "app/panels/panels.h"
#include "app/panels/style.h"

namespace talus::app {
namespace {

void draw_file_menu(PanelContext& context) {
    Session& session = context.session;
    PanelState& state = context.state;
    PanelRequests& requests = context.requests;
    // A dialog would be about a scene that may be another one when the work ends.
    const bool rests = !context.work.busy();
    if (menu_item("Start page", nullptr)) state.start_page = true;
    if (menu_item("New…", "Ctrl+N", rests)) state.fresh.begin();
    if (menu_item("Open…", "Ctrl+O", rests)) state.dialog.begin(FileDialog::Purpose::open, session.path());
    if (ImGui::BeginMenu("Recent")) {
        close_on_escape();
        for (const std::string& file : context.state.recent)
            if (menu_item(file, nullptr)) requests.import = file;
        ImGui::EndMenu();
    }
    ImGui::Separator();
    const bool changes = !state.only_looks;
    if (menu_item("Save", "Ctrl+S", changes && !session.path().empty())) requests.save = session.path();
    if (menu_item("Save as…", "Ctrl+Shift+S", changes && rests))
        state.dialog.begin(FileDialog::Purpose::save, session.path());
    if (menu_item("Save as a scene…", nullptr, changes && rests && can_be_scene(session)))
        state.dialog.begin(FileDialog::Purpose::save_scene, session.path());
    ImGui::Separator();
    if (menu_item("Import into this terrain…", nullptr, changes && rests))
        state.dialog.begin(FileDialog::Purpose::import, session.path());
    if (menu_item("Export…", "Ctrl+E", changes && rests)) state.write.shown = true;
    if (session.scene().document.cut_out) {
        if (menu_item("Put back…", nullptr, rests)) state.dialog.begin_put_back(session);
        if (menu_item("Fly over the whole", nullptr)) requests.open = request_for_whole(session);
    }
    if (menu_item("Save a picture", "F12")) requests.picture = true;
    ImGui::Separator();
    if (menu_item("Quit", "Ctrl+Q")) requests.quit = true;
}

void draw_edit_menu(PanelContext& context) {
    const Undo& history = context.session.simulation().undo_history();
    const std::string undo = history.can_undo() ? "Undo " + history.undo_name() : "Undo";
    const std::string redo = history.can_redo() ? "Redo " + history.redo_name() : "Redo";
    if (menu_item(undo, "Ctrl+Z", history.can_undo())) context.requests.undo = true;
    if (menu_item(redo, "Ctrl+Shift+Z", history.can_redo())) context.requests.redo = true;
    ImGui::Separator();
    if (menu_item("Start the scene over", nullptr, !context.state.only_looks)) context.requests.reset = true;
}

}  // namespace

void draw_menu(PanelContext& context) {
    if (ImGui::BeginMenu("File")) {
        close_on_escape();
        draw_file_menu(context);
        ImGui::EndMenu();
    }
    note_widget("File");
    if (ImGui::BeginMenu("Edit")) {
        close_on_escape();
        draw_edit_menu(context);
        ImGui::EndMenu();
    }
    note_widget("Edit");
    if (ImGui::BeginMenu("View")) {
        close_on_escape();
        if (menu_item("Fit view", "F")) context.requests.framing = true;
        if (menu_item("Top view", "T", true, is_from_top(context.session)))
            toggle_top_view(context.session, context.state);
        if (!context.session.cameras().empty() && ImGui::BeginMenu("Kept cameras")) {
            close_on_escape();
            for (const NamedCamera& camera : context.session.cameras())
                if (menu_item(camera.name, nullptr))
                    context.requests.acts.emplace_back(
                        [wanted = camera.name](Session& s) { s.go_to_camera(wanted); });
            ImGui::EndMenu();
        }
        if (menu_item("All panels", "Tab", true, context.state.panels_shown))
            context.state.panels_shown = !context.state.panels_shown;
        const bool shown_at_all = context.state.panels_shown;
        PanelSide& tools = context.state.tools_side;
        PanelSide& panels = context.state.panels_side;
        if (menu_item("Tools at the left", nullptr, shown_at_all && !context.state.only_looks, !tools.folded))
            tools.folded = !tools.folded;
        if (menu_item("Panels at the right", nullptr, shown_at_all, !panels.folded))
            panels.folded = !panels.folded;
        if (ImGui::BeginMenu("Theme")) {
            close_on_escape();
            for (const Theme& one : themes())
                if (menu_item(one.name, nullptr, true, one.name == theme().name, label_of_name(one.name)))
                    set_theme(one.name);
            ImGui::EndMenu();
        }
        note_widget("Theme");
        ImGui::Separator();
        const std::string& shown = context.session.view().choice("render.view");
        const Parameter& declared = context.session.declaration("render.view");
        for (const render::View& view : render::views())
            if (menu_item(view.name, nullptr, !context.state.only_looks || render::is_of_tiles(view),
                          shown == view.name, label_of_choice(declared, view.name)))
                context.session.set("render.view", view.name);
        ImGui::EndMenu();
    }
    note_widget("View menu");
    if (ImGui::BeginMenu("Help")) {
        close_on_escape();
        if (menu_item("Keys and mouse", "F1")) context.state.keys_shown = true;
        if (menu_item("Verify this device", nullptr)) context.requests.verify = true;
        ImGui::EndMenu();
    }
    note_widget("Help");
    ImGui::TextDisabled("  |  %s%s", context.session.scene().title.c_str(),
                        context.session.unsaved() ? " *" : "");
}

}  // namespace talus::app

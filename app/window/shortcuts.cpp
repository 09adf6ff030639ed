#include "app/window/shortcuts.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>

#include "app/tools/tools.h"

namespace talus::app {
namespace {

void scale(Session& session, const std::string& name, double factor) {
    const Parameter& p = session.declaration(name);
    session.set(name, std::clamp(session.view().number(name) * factor, p.low, p.high));
}

void scale_strength(Session& session, double factor) {
    const std::string& name = tool_named(session.view().choice("brush.tool")).strength;
    if (!name.empty()) scale(session, name, factor);
}

void pick_tool(Session& session, PanelState& state, std::size_t number) {
    if (number >= tools().size()) return;
    session.set("brush.tool", tools()[number].name);
    state.take_brush();
}

// Says why what changes or writes a terrain is not done.
void refuse(PanelRequests& requests) {
    requests.acts.emplace_back([](const Session& session) { session.check_editable(); });
}

void press_with_control(int key, bool shift, Session& session, PanelState& state, PanelRequests& requests) {
    // A field that text is typed into undoes its own.
    if (ImGui::GetIO().WantTextInput && (key == GLFW_KEY_Z || key == GLFW_KEY_Y)) return;
    switch (key) {
        case GLFW_KEY_Z:
            (shift ? requests.redo : requests.undo) = true;
            break;
        case GLFW_KEY_Y:
            requests.redo = true;
            break;
        case GLFW_KEY_N:
            state.fresh.begin();
            break;
        case GLFW_KEY_O:
            state.dialog.begin(FileDialog::Purpose::open, session.path());
            break;
        case GLFW_KEY_S:
            if (state.only_looks)
                refuse(requests);
            else if (shift || session.path().empty())
                state.dialog.begin(FileDialog::Purpose::save, session.path());
            else
                requests.save = session.path();
            break;
        case GLFW_KEY_E:
            if (state.only_looks)
                refuse(requests);
            else
                state.write.shown = true;
            break;
        case GLFW_KEY_Q:
            requests.quit = true;
            break;
        default:
            break;
    }
}

}  // namespace

void press_key(int key, int mods, Session& session, PanelState& state, PanelRequests& requests) {
    const bool shift = (mods & GLFW_MOD_SHIFT) != 0;
    if (state.dialog.purpose != FileDialog::Purpose::none) {
        // A key pressed and released within one slow frame would escape the panels.
        if (key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER) state.dialog.accepted = true;
        if (key == GLFW_KEY_ESCAPE) state.dialog.cancelled = true;
        return;
    }
    if (is_dialog_open(state)) return;
    if ((mods & GLFW_MOD_CONTROL) != 0) return press_with_control(key, shift, session, state, requests);
    if (ImGui::GetIO().WantTextInput) return;
    switch (key) {
        case GLFW_KEY_SPACE:
            requests.acts.emplace_back([](Session& s) { s.toggle_play(); });
            break;
        case GLFW_KEY_PERIOD:
            requests.acts.emplace_back([](Session& s) { s.step(); });
            break;
        case GLFW_KEY_F:
            requests.framing = true;
            break;
        case GLFW_KEY_F12:
            requests.picture = true;
            break;
        case GLFW_KEY_TAB:
            state.panels_shown = !state.panels_shown;
            break;
        case GLFW_KEY_ESCAPE:
            // An open menu or list of choices has it first.
            if (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup)) break;
            state.start_page = false;
            state.placing_gauge = state.placing_section = state.drawing_path = false;
            break;
        case GLFW_KEY_ENTER:
        case GLFW_KEY_KP_ENTER:
            if (state.drawing_path && state.shown == "Paths")
                requests.acts.emplace_back([](Session& s) { s.build_path(); });
            break;
        case GLFW_KEY_BACKSPACE:
            if (state.drawing_path && state.shown == "Paths")
                requests.acts.emplace_back([](Session& s) { s.path_draft().remove_last(); });
            break;
        case GLFW_KEY_LEFT_BRACKET:
            scale(session, "brush.radius_m", 1 / 1.15);
            break;
        case GLFW_KEY_RIGHT_BRACKET:
            scale(session, "brush.radius_m", 1.15);
            break;
        case GLFW_KEY_MINUS:
            scale_strength(session, 1 / 1.15);
            break;
        case GLFW_KEY_EQUAL:
            scale_strength(session, 1.15);
            break;
        default:
            // 1 to 9 are the first tools, with Shift the others.
            if (key >= GLFW_KEY_1 && key <= GLFW_KEY_9)
                pick_tool(session, state, static_cast<std::size_t>(key) - GLFW_KEY_1 + (shift ? 9U : 0U));
    }
}

}  // namespace talus::app

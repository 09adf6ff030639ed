#include "app/window/shortcuts.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <string>

#include "app/panels/panels.h"
#include "app/tools/tools.h"

namespace talus::app {
namespace {

/// What a key is pressed upon.
struct Desk {
    Session& session;
    PanelState& state;
    PanelRequests& requests;
};

void scale(Session& session, const std::string& name, double factor) {
    const Parameter& p = session.declaration(name);
    session.set(name, std::clamp(session.view().number(name) * factor, p.low, p.high));
}

void scale_radius(const Desk& on, double factor) {
    scale(on.session, "brush.radius_m", factor);
}

void scale_strength(const Desk& on, double factor) {
    const std::string& name = tool_named(on.session.view().choice("brush.tool")).strength;
    if (!name.empty()) scale(on.session, name, factor);
}

// Says why what changes or writes a terrain is not done, where it is not.
bool is_refused(const Desk& on) {
    if (on.state.only_looks)
        on.requests.acts.emplace_back([](const Session& session) { session.check_editable(); });
    return on.state.only_looks;
}

void save(const Desk& on) {
    if (is_refused(on)) return;
    if (on.session.path().empty())
        on.state.dialog.begin(FileDialog::Purpose::save, on.session.path());
    else
        on.requests.save = on.session.path();
}

void save_as(const Desk& on) {
    if (!is_refused(on)) on.state.dialog.begin(FileDialog::Purpose::save, on.session.path());
}

void leave(const Desk& on) {
    on.state.keyboard_in = KeyboardIn::picture;
    // An open menu or list of choices has it first.
    if (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup)) return;
    on.state.start_page = false;
    on.state.take_brush();
}

// From the picture to the tools, to the panels, and back.
void move_keyboard(const Desk& on) {
    KeyboardIn& now = on.state.keyboard_in;
    on.state.panels_shown = true;
    on.state.tools_side.folded = on.state.panels_side.folded = false;
    if (now == KeyboardIn::picture && !on.state.only_looks)
        now = KeyboardIn::tools;
    else
        now = now == KeyboardIn::panels ? KeyboardIn::picture : KeyboardIn::panels;
}

bool draws_path(const Desk& on) {
    return on.state.drawing_path && on.state.shown == "Paths";
}

// What is wished for by what one sees, though it may be done later.
void play(const Desk& on) {
    on.requests.acts.emplace_back(
        [plays = !on.session.playing](Session& session) { session.set_playing(plays); });
}

void build_path(const Desk& on) {
    if (draws_path(on)) on.requests.acts.emplace_back([](Session& s) { s.build_path(); });
}

void remove_point(const Desk& on) {
    if (draws_path(on)) on.requests.acts.emplace_back([](Session& s) { s.path_draft().remove_last(); });
}

/// Whether it is done again and again while it is held: never, where no tick goes on, or anyway.
enum class Held { once, at_rest, repeats };

enum class With { nothing, control, control_shift };

struct Shortcut {
    int key;  ///< GLFW's
    With with;
    const char* keys;  ///< as they are listed; empty: another key has that line
    const char* what;
    void (*act)(const Desk&);
    const char* group = "";  ///< a heading before it
    Held held = Held::once;
};

constexpr std::array<Shortcut, 26> shortcuts = {{
    {GLFW_KEY_N, With::control, "Ctrl+N", "New terrain", [](const Desk& on) { on.state.fresh.begin(); },
     "Files"},
    {GLFW_KEY_O, With::control, "Ctrl+O", "Open a file",
     [](const Desk& on) { on.state.dialog.begin(FileDialog::Purpose::open, on.session.path()); }},
    {GLFW_KEY_S, With::control, "Ctrl+S", "Save", save},
    {GLFW_KEY_S, With::control_shift, "Ctrl+Shift+S", "Save as another document", save_as},
    {GLFW_KEY_E, With::control, "Ctrl+E", "Export for other programs",
     [](const Desk& on) {
         if (!is_refused(on)) on.state.write.shown = true;
     }},
    {GLFW_KEY_F12, With::nothing, "F12", "Save a picture of the view",
     [](const Desk& on) { on.requests.picture = true; }},
    {GLFW_KEY_F9, With::nothing, "F9", "Record a film of the view; end it",
     [](const Desk& on) { on.requests.record = true; }},
    {GLFW_KEY_Q, With::control, "Ctrl+Q", "Quit", [](const Desk& on) { on.requests.quit = true; }},
    {GLFW_KEY_SPACE, With::nothing, "Space", "Play, pause", play, "Work"},
    {GLFW_KEY_PERIOD, With::nothing, ".", "One tick",
     [](const Desk& on) { on.requests.acts.emplace_back([](Session& s) { s.begin_step(); }); }, "",
     Held::at_rest},
    {GLFW_KEY_Z, With::control, "Ctrl+Z", "Undo", [](const Desk& on) { on.requests.undo = true; }, "",
     Held::at_rest},
    {GLFW_KEY_Z, With::control_shift, "Ctrl+Shift+Z, Ctrl+Y", "Redo",
     [](const Desk& on) { on.requests.redo = true; }, "", Held::at_rest},
    {GLFW_KEY_Y, With::control, "", "", [](const Desk& on) { on.requests.redo = true; }, "", Held::at_rest},
    {GLFW_KEY_ESCAPE, With::nothing, "Escape", "Leave the start page, or what was to be placed", leave},
    {GLFW_KEY_ENTER, With::nothing, "Enter", "Build the path that is drawn", build_path},
    {GLFW_KEY_KP_ENTER, With::nothing, "", "", build_path},
    {GLFW_KEY_BACKSPACE, With::nothing, "Backspace", "Take away the last point of the path", remove_point, "",
     Held::at_rest},
    {GLFW_KEY_TAB, With::nothing, "Tab", "Hide panels, show them",
     [](const Desk& on) { on.state.panels_shown = !on.state.panels_shown; }},
    {GLFW_KEY_F6, With::nothing, "F6", "The keyboard moves in the tools, in the panels, in the picture",
     move_keyboard},
    {GLFW_KEY_F, With::nothing, "F", "Fit the view to the whole terrain",
     [](const Desk& on) { on.requests.framing = true; }},
    {GLFW_KEY_T, With::nothing, "T", "Look straight down, as on a map; back",
     [](const Desk& on) { toggle_top_view(on.session, on.state); }},
    {GLFW_KEY_F1, With::nothing, "F1", "This list", [](const Desk& on) { on.state.keys_shown = true; }},
    {GLFW_KEY_LEFT_BRACKET, With::nothing, "[", "Smaller brush",
     [](const Desk& on) { scale_radius(on, 1 / 1.15); }, "Brush", Held::repeats},
    {GLFW_KEY_RIGHT_BRACKET, With::nothing, "]", "Larger brush",
     [](const Desk& on) { scale_radius(on, 1.15); }, "", Held::repeats},
    {GLFW_KEY_MINUS, With::nothing, "-", "Weaker brush", [](const Desk& on) { scale_strength(on, 1 / 1.15); },
     "", Held::repeats},
    {GLFW_KEY_EQUAL, With::nothing, "=", "Stronger brush", [](const Desk& on) { scale_strength(on, 1.15); },
     "", Held::repeats},
}};

// What is no key's alone.
const std::array<KeyLine, 20> ways_of_the_mouse = {{
    {"Left button", "The brush; places what is to be placed"},
    {"Ctrl, Shift", "Held under a stroke: turns the tool around; smooths"},
    {"", "Camera"},
    {"Right button", "Turns the camera; from the top, shifts it"},
    {"Middle button", "Shifts it"},
    {"Wheel", "Nearer, farther"},
    {"W A S D", "Fly or walk; shift the map"},
    {"Q, E", "Down, up; nearer, farther on the map"},
    {"", "Numbers in panels"},
    {"Drag", "Changes a number"},
    {"Click", "An exact number is typed, Enter takes it"},
    {"Ctrl and a click", "The same on a slider"},
    {"Right click", "Unsets it"},
    {"", "The keyboard in panels (F6)"},
    {"Arrows", "From one to the next; Alt: the menu"},
    {"Space", "Presses a button, takes a number to change by arrows"},
    {"Enter", "Types a number"},
    {"", "Dialogs and menus"},
    {"Enter", "Does what the dialog of files is for"},
    {"Escape", "Closes a dialog, a menu or a list"},
}};

// 1 to 9 are the first tools, with Shift the others.
void pick_tool(const Desk& on, std::size_t number) {
    if (number >= tools().size()) return;
    on.session.set("brush.tool", tools()[number].name);
    on.state.take_brush();
}

With with_what(int mods) {
    if ((mods & GLFW_MOD_CONTROL) == 0) return With::nothing;
    return (mods & GLFW_MOD_SHIFT) != 0 ? With::control_shift : With::control;
}

}  // namespace

std::vector<KeyLine> key_lines() {
    std::vector<KeyLine> lines;
    for (const Shortcut& one : shortcuts) {
        if (*one.group != '\0') lines.push_back({"", one.group});
        if (*one.keys != '\0') lines.push_back({one.keys, one.what});
    }
    for (std::size_t i = 0; i < tools().size(); ++i)
        lines.push_back(
            {(i < 9 ? "" : "Shift+") + std::to_string(i % 9 + 1), "Tool: " + label_of_name(tools()[i].name)});
    lines.insert(lines.end(), ways_of_the_mouse.begin(), ways_of_the_mouse.end());
    return lines;
}

void press_key(const PressedKey& pressed, Session& session, PanelState& state, PanelRequests& requests) {
    const int key = pressed.key;
    const int mods = pressed.mods;
    if (state.dialog.purpose != FileDialog::Purpose::none) {
        // A key pressed and released within one slow frame would escape the panels.
        if (key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER) state.dialog.accepted = true;
        if (key == GLFW_KEY_ESCAPE) state.dialog.cancelled = true;
        return;
    }
    if (is_dialog_open(state)) return;
    const Desk on{session, state, requests};
    const With with = with_what(mods);
    // A field that text is typed into has its keys, and undoes its own.
    if (ImGui::GetIO().WantTextInput && (with == With::nothing || key == GLFW_KEY_Z || key == GLFW_KEY_Y))
        return;
    auto found = std::find_if(shortcuts.begin(), shortcuts.end(),
                              [&](const Shortcut& one) { return one.key == key && one.with == with; });
    // Where they move from widget to widget, keys are the panels': but for Ctrl's, F6's and its like, and
    // Escape.
    const bool is_special = key == GLFW_KEY_ESCAPE || (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F25);
    if (state.keyboard_in != KeyboardIn::picture && with == With::nothing && !is_special) return;
    // Where Shift says nothing else, it says nothing.
    if (found == shortcuts.end() && with == With::control_shift)
        found = std::find_if(shortcuts.begin(), shortcuts.end(), [&](const Shortcut& one) {
            return one.key == key && one.with == With::control;
        });
    if (found != shortcuts.end()) {
        // What waits for a tick is not asked for again and again.
        const bool again = found->held == Held::repeats ||
                           (found->held == Held::at_rest && requests.acts.empty() && !session.mid_tick());
        if (!pressed.repeats || again) found->act(on);
        return;
    }
    if (with == With::nothing && key >= GLFW_KEY_1 && key <= GLFW_KEY_9)
        pick_tool(on, static_cast<std::size_t>(key) - GLFW_KEY_1 + ((mods & GLFW_MOD_SHIFT) != 0 ? 9U : 0U));
}

}  // namespace talus::app

#pragma once
#include <vector>

#include "app/core/dialogs.h"

namespace talus::app {

/// A key that was pressed, or that repeats while it is held: GLFW's key and modifiers.
struct PressedKey {
    int key = 0;
    int mods = 0;
    bool repeats = false;
};

/// What it means, outside of fields that text is typed into.
void press_key(const PressedKey& pressed, Session& session, PanelState& state, PanelRequests& requests);

/// What all keys do, and the mouse, with headings between.
std::vector<KeyLine> key_lines();

}  // namespace talus::app

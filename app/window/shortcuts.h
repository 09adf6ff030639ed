#pragma once
#include "app/core/dialogs.h"

namespace talus::app {

/// A key was pressed, or repeats (GLFW's key and modifiers): what it means, outside of fields that text is
/// typed into.
void press_key(int key, int mods, Session& session, PanelState& state, PanelRequests& requests);

}  // namespace talus::app

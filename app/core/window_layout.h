#pragma once
#include <glm/glm.hpp>
#include <string>

namespace talus::app {

/// The panels at one side of the window.
struct PanelSide {
    float width_em = 20;  ///< in heights of a letter
    bool folded = false;  ///< to a button that brings them back
    bool operator==(const PanelSide&) const = default;
};

/// How the window looked when it was last closed.
struct WindowLayout {
    glm::ivec2 size{1280, 720};
    std::string panel = "Simulation";
    bool panels_shown = true;
    PanelSide tools_side{17};
    PanelSide panels_side{23};
    std::string theme = "";  ///< of the panels; empty: the first one
};

/// As it was kept, or the first one. What cannot be read is as if it were not there.
WindowLayout read_window_layout();
/// A layout that cannot be written costs the next start its looks.
void keep_window_layout(const WindowLayout& layout);

}  // namespace talus::app

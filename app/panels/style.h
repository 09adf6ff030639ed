#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <string>

namespace talus::app {

/// Colours of the panels, sRGB with alpha, from 0 to 1.
struct Theme {
    const char* name;  ///< as --theme and the menu View have it
    glm::vec4 text;
    glm::vec4 faint;    ///< text that explains, or of what cannot be chosen
    glm::vec4 heading;  ///< text
    glm::vec4 warning;  ///< text
    glm::vec4 good;     ///< text
    glm::vec4 panel;    ///< below all of them, as those that follow
    glm::vec4 popup;    ///< dialogs, menus and lists
    glm::vec4 field;
    glm::vec4 button;
    glm::vec4 hovered;
    glm::vec4 chosen;  ///< what is down, or chosen
    glm::vec4 bar;     ///< the status line
    glm::vec4 notice;
    glm::vec4 handle;  ///< of a slider, below its number
    glm::vec4 border;
    float border_px;
};

/// All themes; the first one is that of who chose none.
const std::array<Theme, 2>& themes();
/// The one that panels have now.
const Theme& theme();
/// Panels have the theme of this name from now on; of a name that there is none of, the first one.
void set_theme(const std::string& name);
/// As ImGui's draw lists take it.
std::uint32_t colour_of(glm::vec4 colour);

/// How panels look, at this scale, in the first theme; loads their font. Once.
void set_style(float scale);
/// So many heights of a letter, pixels; before the first frame too.
float em(float times);

}  // namespace talus::app

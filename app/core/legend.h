#pragma once
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "render/view.h"

namespace talus::app {

/// Legends as shapes, in the lower right corner of a picture; pixels from the upper left. Panels and pictures
/// for files draw the same.
struct LegendDrawing {
    struct Box {
        glm::vec2 low;
        glm::vec2 high;
        glm::u8vec4 colour;  ///< with alpha
        float rounding = 0;
    };
    struct Text {
        glm::vec2 at;  ///< its upper left corner
        std::string words;
    };
    std::vector<Box> boxes;   ///< below the texts
    std::vector<Text> texts;  ///< white
};

/// `line_px`: height of a line of text; `width_of`: of a text, pixels.
LegendDrawing legend_drawing(const std::vector<render::Legend>& legends, glm::ivec2 size, float line_px,
                             const std::function<float(const std::string&)>& width_of);

/// The font that panels and legends are set in, a file; empty: there is none.
std::string font_file();

/// Draws the legends into a picture, rows of RGB from the top.
void draw_legends(const std::vector<render::Legend>& legends, glm::ivec2 size,
                  std::vector<std::uint8_t>& rgb);

}  // namespace talus::app

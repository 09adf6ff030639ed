#pragma once
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace talus::app {

/// An icon is drawn in lines: "1,14 8,2 15,14; 4,10 12,10" are two of them through these points, columns and
/// rows of a square of this side, from its upper left.
constexpr float icon_side = 16;

/// Its lines. Throws talus::Error where the text is none of an icon.
std::vector<std::vector<glm::vec2>> icon_lines(const std::string& icon);

}  // namespace talus::app

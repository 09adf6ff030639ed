#pragma once
#include <cmath>
#include <glm/glm.hpp>

namespace talus::app {

/// Between samples as the surface is (docs/numerics.md, "Surface"): `place` in columns and rows among `count`
/// samples, at least 2 a side, and height(column, row) of each.
template <typename Height>
double bilinear(glm::dvec2 place, glm::ivec2 count, Height&& height) {
    const glm::ivec2 patch = glm::clamp(glm::ivec2(glm::floor(place)), glm::ivec2(0), count - 2);
    const glm::dvec2 in = place - glm::dvec2(patch);
    return std::lerp(std::lerp(height(patch.x, patch.y), height(patch.x + 1, patch.y), in.x),
                     std::lerp(height(patch.x, patch.y + 1), height(patch.x + 1, patch.y + 1), in.x), in.y);
}

}  // namespace talus::app

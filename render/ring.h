#pragma once
#include <glm/glm.hpp>

#include "sim/gpu/texture.h"

namespace talus::render {

/// What lies over a picture, on the ground under the mouse: a brush's ring, or a stamp as it would be
/// pressed.
struct Ring {
    glm::dvec2 at_m{0};
    double radius_m = 0;                  ///< 0: nothing lies there
    const gpu::Texture* stamp = nullptr;  ///< heights, 0 to 1; none: a ring
    glm::dvec2 stamp_columns{0};          ///< of the stamp, a metre east and north, from its middle
    glm::dvec2 stamp_rows{0};
};

}  // namespace talus::render

#pragma once
#include <glm/glm.hpp>

#include "sim/passes/dab.h"
#include "sim/terrain/grid.h"

namespace talus {

/// A dab in the units of shaders/maths/brush.glsl. The twin takes the same numbers.
struct DabStep {
    glm::vec2 cell_m{1};
    glm::ivec2 sample{0};
    glm::vec2 offset{0};
    float radius_m = 0;
    float falloff = 0;
    int curve = 0;
    glm::vec2 length_m{0};
    int mode = 0;
    float amount_m = 0;
    float blend = 0;
    glm::vec2 target_m{0};
    float rise_m = 0;
    int on_regolith = 0;
    glm::vec2 stamp_columns{0};
    glm::vec2 stamp_rows{0};
    float stamp_zero = 0;
};
/// `stamp_samples`: columns and rows of the stamp, for a dab of it.
DabStep dab_step(const Grid& grid, const Dab& dab, glm::ivec2 stamp_samples = {2, 2});

}  // namespace talus

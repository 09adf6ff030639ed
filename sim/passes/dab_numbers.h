#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "shaders/maths/twin.h"
#include "sim/passes/dab.h"
#include "sim/terrain/grid.h"

namespace talus {

/// What shaders are told of a dab; the twin takes the same numbers.
struct DabNumbers {
    TALUS_TWIN_NAMES(float)
#define NUMBER TALUS_MEMBER
#include "maths/dab_numbers.glsl"
#undef NUMBER
};

/// `stamp_samples`: columns and rows of the stamp, for a dab of it.
DabNumbers dab_numbers(const Grid& grid, const Dab& dab, glm::ivec2 stamp_samples = {2, 2});

/// The points of a dab of a path, as shaders/maths/path.glsl has them; the fourth numbers are 0.
std::vector<glm::vec4> path_line(const Dab& dab);

}  // namespace talus

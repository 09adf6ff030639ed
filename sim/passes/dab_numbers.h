#pragma once
#include <glm/glm.hpp>

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

}  // namespace talus

#pragma once
#include "shaders/maths/twin.h"
#include "sim/passes/water_settings.h"

namespace talus {

/// What shaders are told of the water in a tick; the twin takes the same numbers.
struct WaterNumbers {
    TALUS_TWIN_NAMES(float)
#define NUMBER TALUS_MEMBER
#include "maths/water_numbers.glsl"
#undef NUMBER
};
/// `tiles`: of the terrain, across and down. `series`: the tick's tables (sim/passes/tick_series.h).
WaterNumbers water_numbers(const Grid& grid, glm::ivec2 tiles, const WaterSettings& settings, double tick_s,
                           std::size_t springs, const std::vector<float>& series);

}  // namespace talus

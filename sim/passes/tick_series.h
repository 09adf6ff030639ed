#pragma once
#include <vector>

#include "sim/passes/water_settings.h"
#include "sim/terrain/grid.h"

namespace talus {

namespace glsl {
#include "maths/tick_series.glsl"
}  // namespace glsl

/// The tables that the water reads in a tick of tick_s that begins at start_s, one behind the other as
/// shaders/maths/tick_series.glsl says. Inflow and rain are means of its steps, so that what they bring is
/// their integral, however fast they change.
std::vector<float> tick_series(const WaterSettings& settings, const Grid& grid, double tick_s,
                               double start_s);

}  // namespace talus

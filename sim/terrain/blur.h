#pragma once
#include "sim/terrain/terrain.h"

namespace talus {

/// The terrain with its ground blurred by a Gaussian of this standard deviation: what is lower after it is
/// taken, regolith first, what is higher is bedrock. `masked`: as far as the painted mask says. Throws
/// talus::Error when the deviation is not above 0 and at most 256 samples.
TerrainState with_blurred_ground(TerrainState state, double deviation_m, bool masked);

/// The same with the painted mask blurred.
TerrainState with_blurred_mask(TerrainState state, double deviation_m);

}  // namespace talus

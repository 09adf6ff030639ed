#pragma once
#include "sim/terrain/terrain.h"

namespace talus {

/// Blurs the ground by a Gaussian of this standard deviation (samples east and south): what is lower after it
/// is taken, regolith first, what is higher is bedrock. `masked`: as far as the painted mask says. Waits for
/// the device.
void blur_ground(Terrain& terrain, glm::dvec2 deviation, bool masked);

/// Blurs the painted mask. Waits for the device.
void blur_mask(Terrain& terrain, glm::dvec2 deviation);

}  // namespace talus

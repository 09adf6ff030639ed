#pragma once
#include "sim/terrain/terrain.h"

namespace talus {

/// Fills ground below the level (m) that is connected to the map's edge, sample to sample across their sides.
/// Where the ground beyond the edge is known, it must lie below the level too. Water that stands higher
/// stays. Returns the m³ that came in.
double fill_sea(TerrainState& state, double level_m);

}  // namespace talus

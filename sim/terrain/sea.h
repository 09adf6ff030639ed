#pragma once
#include "sim/terrain/terrain.h"

namespace talus {

/// Fills what lies below the level (m) and is connected to the edge of the map by ground below it, sample to
/// sample across their sides, and beyond it where that is known. Water that stands higher stays. Returns the
/// m³ that came in.
double fill_sea(TerrainState& state, double level_m);

}  // namespace talus

#pragma once
#include <string>

#include "sim/parameters.h"
#include "sim/terrain/terrain.h"

namespace talus::app {

/// One sentence on how true to nature the wave maker's sine is over the still depth at its edges, a warning
/// above 5 %; empty where there is no such wave.
std::string wave_note(const TerrainState& state, const Parameters& parameters);

}  // namespace talus::app

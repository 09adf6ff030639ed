#pragma once
#include <vector>

#include "sim/parameters.h"

namespace talus {

/// What presets, operations and journals may set: the parameters that decide how the terrain comes out.
std::vector<Parameter> simulation_parameters();

}  // namespace talus

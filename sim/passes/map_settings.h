#pragma once
#include <vector>

#include "sim/parameters.h"

namespace talus {

/// Parameters of the maps of flow, wear and deposition (docs/numerics.md, "Maps").
const std::vector<Parameter>& map_parameters();

/// Whether passes count flow, wear and deposition.
bool counts_maps(const Parameters& parameters);

}  // namespace talus

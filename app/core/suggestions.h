#pragma once
#include <glm/glm.hpp>

#include "sim/parameters.h"
#include "sim/terrain/grid.h"

namespace talus::app {

/// What a terrain suggests to parameters of the view and the hand that nobody set: sizes and speeds that go
/// with its own. bounds_m: its lowest and highest sample. in_tiles: it is looked at, and a part of it is to
/// be chosen.
void suggest_sizes(Parameters& view, const Grid& grid, glm::dvec2 bounds_m, bool in_tiles);

}  // namespace talus::app

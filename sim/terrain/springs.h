#pragma once
#include <vector>

#include "sim/terrain/terrain_state.h"

namespace talus {

/// Throws talus::Error when a spring lies off the map, or its rate is not 0 to 1e9 m³/s.
void check_spring(const Grid& grid, const Spring& spring);

/// The sample that it feeds: column and row, as layers count them.
glm::ivec2 sample_of(const Grid& grid, const Spring& spring);

/// Sets it among the springs, in place of one at the same sample; a rate of 0 takes that away.
void place_spring(const Grid& grid, std::vector<Spring>& springs, const Spring& spring);

}  // namespace talus

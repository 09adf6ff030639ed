#pragma once
#include <vector>

#include "sim/terrain/grid.h"

namespace talus {

/// A relief to press into terrains: heights from 0 to 1 on a grid, row 0 north, and how high it was.
struct Stamp {
    Grid grid;
    std::vector<float> heights;
    double relief_m = 0;
};

/// Heights in metres as a stamp: the lowest becomes 0, the highest 1; level ones 1. Throws talus::Error when
/// the grid cannot be used.
Stamp stamp_of(const Grid& grid, const std::vector<float>& heights_m);

}  // namespace talus

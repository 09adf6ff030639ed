#pragma once
#include <string>
#include <vector>

#include "sim/terrain/grid.h"

namespace talus {

/// A relief to press into terrains: heights from 0, its lowest sample, to 1 on a grid, row 0 north, and how
/// high it was.
struct Stamp {
    Grid grid;
    std::vector<float> heights;
    double relief_m = 0;
    double border = 0;           ///< the median of its outermost samples, as a height from 0 to 1
    bool in_proportion = false;  ///< unless somebody says how high, it is as high as it is wide in proportion
    double file_zero = 0;  ///< the height of 0 m in the file, on the same scale: may lie below 0 or above 1
};

/// Heights in metres as a stamp: the lowest becomes 0, the highest 1. A level stamp is 1
/// everywhere, and its zero is 0. Throws
/// talus::Error when the grid cannot be used.
Stamp stamp_of(const Grid& grid, const std::vector<float>& heights_m);

/// Its height where its longer side is pressed this wide, if nobody says how high, m.
double natural_relief_m(const Stamp& stamp, double width_m);

/// Which height of a stamp stands on the ground: that of its border, its lowest sample, or 0 m of its file.
enum class StampZero { border = 0, lowest, file };
const std::vector<std::string>& stamp_zero_names();
/// That height on the scale of its samples.
double zero_of(const Stamp& stamp, StampZero zero);

}  // namespace talus

#include "sim/terrain/stamp.h"

#include <algorithm>

namespace talus {

Stamp stamp_of(const Grid& grid, const std::vector<float>& heights_m) {
    check_grid(grid);
    const auto ends = std::minmax_element(heights_m.begin(), heights_m.end());
    const double low_m = *ends.first;
    Stamp stamp{grid, std::vector<float>(heights_m.size(), 1.0F), *ends.second - low_m};
    if (stamp.relief_m > 0)
        std::transform(heights_m.begin(), heights_m.end(), stamp.heights.begin(),
                       [&](float height) { return static_cast<float>((height - low_m) / stamp.relief_m); });
    return stamp;
}

}  // namespace talus

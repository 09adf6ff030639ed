#include "sim/terrain/springs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/gpu/error.h"

namespace talus {

void check_spring(const Grid& grid, const Spring& spring) {
    const std::string text = fmt::format("spring at {},{}", spring.x_m, spring.y_m);
    if (!(spring.x_m >= 0 && spring.x_m <= grid.width_m() && spring.y_m >= 0 &&
          spring.y_m <= grid.height_m()))
        throw Error(fmt::format("{} m lies off the map, it must lie within 0,0 and {},{} m", text,
                                grid.width_m(), grid.height_m()));
    if (!(spring.rate_m3_per_s >= 0 && spring.rate_m3_per_s <= 1e9))
        throw Error(
            fmt::format("{} m cannot give {} m³/s, its rate must be 0 to 1e9", text, spring.rate_m3_per_s));
}

void place_spring(const Grid& grid, std::vector<Spring>& springs, const Spring& spring) {
    const auto sample = [&](const Spring& s) {
        return glm::dvec2(std::round(grid.column_of(s.x_m)), std::round(grid.row_of(s.y_m)));
    };
    springs.erase(std::remove_if(springs.begin(), springs.end(),
                                 [&](const Spring& s) { return sample(s) == sample(spring); }),
                  springs.end());
    if (spring.rate_m3_per_s > 0) springs.push_back(spring);
}

}  // namespace talus

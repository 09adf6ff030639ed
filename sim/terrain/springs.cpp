#include "sim/terrain/springs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/error.h"

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

glm::ivec2 sample_of(const Grid& grid, const Spring& spring) {
    return {std::clamp(std::round(grid.column_of(spring.x_m)), 0.0, grid.nx - 1.0),
            std::clamp(std::round(grid.row_of(spring.y_m)), 0.0, grid.ny - 1.0)};
}

void place_spring(const Grid& grid, std::vector<Spring>& springs, const Spring& spring) {
    std::erase_if(springs, [&](const Spring& s) { return sample_of(grid, s) == sample_of(grid, spring); });
    if (spring.rate_m3_per_s > 0) springs.push_back(spring);
}

}  // namespace talus

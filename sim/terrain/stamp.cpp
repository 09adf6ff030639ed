#include "sim/terrain/stamp.h"

#include <algorithm>

namespace talus {
namespace {

// The middle one of the outermost samples.
float median_of_border(const Grid& grid, const std::vector<float>& heights) {
    std::vector<float> border;
    for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x)
            if (x == 0 || y == 0 || x == grid.nx - 1 || y == grid.ny - 1)
                border.push_back(heights[static_cast<std::size_t>(y) * grid.nx + x]);
    const auto middle = border.begin() + static_cast<std::ptrdiff_t>(border.size() / 2);
    std::nth_element(border.begin(), middle, border.end());
    return *middle;
}

}  // namespace

const std::vector<std::string>& stamp_zero_names() {
    static const std::vector<std::string> names = {"border", "lowest", "file"};
    return names;
}

Stamp stamp_of(const Grid& grid, const std::vector<float>& heights_m) {
    check_grid(grid);
    const auto ends = std::minmax_element(heights_m.begin(), heights_m.end());
    const double low_m = *ends.first;
    Stamp stamp{grid, std::vector<float>(heights_m.size(), 1.0F), *ends.second - low_m};
    if (stamp.relief_m <= 0) return stamp;
    std::transform(heights_m.begin(), heights_m.end(), stamp.heights.begin(),
                   [&](float height) { return static_cast<float>((height - low_m) / stamp.relief_m); });
    stamp.border = median_of_border(grid, stamp.heights);
    stamp.file_zero = -low_m / stamp.relief_m;
    return stamp;
}

double natural_relief_m(const Stamp& stamp, double width_m) {
    if (!stamp.in_proportion) return stamp.relief_m;
    return stamp.relief_m * width_m / std::max(stamp.grid.width_m(), stamp.grid.height_m());
}

double zero_of(const Stamp& stamp, StampZero zero) {
    switch (zero) {
        case StampZero::border:
            return stamp.border;
        case StampZero::file:
            return stamp.file_zero;
        default:
            return 0;
    }
}

}  // namespace talus

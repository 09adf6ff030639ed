#include "sim/passes/dab_region.h"

#include <algorithm>
#include <cmath>

namespace talus {

gpu::Region dab_region(const Grid& grid, const Dab& dab) {
    if (dab.as<ErodeDab>()) return erode_window(grid, dab);
    const auto whole = [](double v) { return static_cast<int>(std::clamp(v, -1e6, 1e6)); };
    glm::dvec2 low = glm::min(glm::dvec2(0), dab.way_m());
    glm::dvec2 high = glm::max(glm::dvec2(0), dab.way_m());
    if (const auto* path = dab.as<PathDab>())
        for (const glm::dvec3& point : path->points_m) {
            const glm::dvec2 way = glm::dvec2(point) - glm::dvec2(dab.x_m, dab.y_m);
            low = glm::min(low, way);
            high = glm::max(high, way);
        }
    low -= dab.radius_m;
    high += dab.radius_m;
    const int x0 = whole(std::ceil(grid.column_of(dab.x_m + low.x)));
    const int x1 = whole(std::floor(grid.column_of(dab.x_m + high.x)));
    const int y0 = whole(std::ceil(grid.row_of(dab.y_m + high.y)));
    const int y1 = whole(std::floor(grid.row_of(dab.y_m + low.y)));
    return {x0, y0, x1 - x0 + 1, y1 - y0 + 1};
}

gpu::Region erode_window(const Grid& grid, const Dab& dab) {
    // Half a radius beside the brush, and room for the solver's neighbours.
    const auto half = [&](double spacing_m) {
        return static_cast<int>(std::min(std::ceil(1.5 * dab.radius_m / spacing_m) + 2, 1e6));
    };
    const auto side = [](int half_side, int count) { return std::min(2 * half_side + 1, count); };
    const auto first = [](double at, int half_side, int size, int count) {
        const double middle = std::clamp(std::round(at), -1e6, 1e6);
        return std::clamp(static_cast<int>(middle) - half_side, 0, count - size);
    };
    const int width = side(half(grid.dx), grid.nx);
    const int height = side(half(grid.dy), grid.ny);
    return {first(grid.column_of(dab.x_m), half(grid.dx), width, grid.nx),
            first(grid.row_of(dab.y_m), half(grid.dy), height, grid.ny), width, height};
}

}  // namespace talus

#include "app/core/suggestions.h"

#include <algorithm>

namespace talus::app {
void suggest_sizes(Parameters& view, const Grid& grid, glm::dvec2 bounds_m, bool in_tiles) {
    const double extent = std::max(grid.width_m(), grid.height_m());
    view.suggest("brush.radius_m", extent / 40);
    view.suggest("brush.rate_m_per_s", extent / 160);
    view.suggest("camera.speed_m_per_s", extent / 12);
    view.suggest("erode.speed", 6 * std::min(grid.dx, grid.dy));
    view.suggest("path.width_m", std::max(8.0, 3 * std::min(grid.dx, grid.dy)));
    view.suggest("noise.wavelength_m", extent / 12);
    if (!in_tiles) {
        view.suggest("map.nx", grid.nx);
        view.suggest("map.ny", grid.ny);
        view.suggest("map.east_m", grid.width_m());
        view.suggest("map.north_m", grid.height_m());
    } else {
        // A part in the middle, of a size to work in.
        constexpr double samples = 1024;
        const glm::dvec2 all(grid.width_m(), grid.height_m());
        const glm::dvec2 size = glm::min(all, samples * glm::dvec2(grid.dx, grid.dy));
        view.suggest("map.west_m", (all.x - size.x) / 2);
        view.suggest("map.south_m", (all.y - size.y) / 2);
        view.suggest("map.east_m", (all.x + size.x) / 2);
        view.suggest("map.north_m", (all.y + size.y) / 2);
    }
    view.suggest("terrace.step_m", std::max(0.01, (bounds_m.y - bounds_m.x) / 20));
    view.suggest("brush.height_m", bounds_m.x);
    view.suggest("map.base_m", bounds_m.x);
}

}  // namespace talus::app

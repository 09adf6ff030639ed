#include "sim/terrain/georeference.h"

namespace talus {

glm::dvec2 coordinates_of(const Georeference& georeference, const Grid& grid, glm::dvec2 place_m) {
    const std::array<double, 6>& t = georeference.transform;
    // Samples stand in the middle of pixels.
    const double column = grid.column_of(place_m.x) + 0.5;
    const double row = grid.row_of(place_m.y) + 0.5;
    return {t[0] + column * t[1] + row * t[2], t[3] + column * t[4] + row * t[5]};
}

}  // namespace talus

#include "sim/terrain/gauge.h"

#include <algorithm>
#include <cmath>

namespace talus {

glm::dvec2 water_velocity(double depth_m, glm::dvec2 discharge) {
    constexpr double film_m = 1e-6;
    const double square = depth_m * depth_m;
    return discharge * (2 * depth_m / (square + std::max(square, film_m * film_m)));
}

gpu::Region gauge_sample(const Grid& grid, double x_m, double y_m) {
    const int column = static_cast<int>(std::clamp(std::round(grid.column_of(x_m)), 0.0, grid.nx - 1.0));
    const int row = static_cast<int>(std::clamp(std::round(grid.row_of(y_m)), 0.0, grid.ny - 1.0));
    return {column, row, 1, 1};
}

void set_water(GaugeReading& reading, const glm::vec4& water) {
    reading.depth_m = static_cast<double>(water.x) + water.y;
    reading.velocity_m_per_s = water_velocity(reading.depth_m, {water.z, water.w});
}

GaugeReading read_gauge(const Terrain& terrain, double x_m, double y_m) {
    const gpu::Region sample = gauge_sample(terrain.grid(), x_m, y_m);
    GaugeReading reading;
    float ground = 0;
    terrain.ground.read(sample, std::as_writable_bytes(std::span(&ground, 1)));
    reading.ground_m = ground;
    if (!terrain.water) return reading;
    glm::vec4 water(0);
    terrain.water->front.read(terrain.water->texels(sample), std::as_writable_bytes(std::span(&water, 1)));
    set_water(reading, water);
    return reading;
}

}  // namespace talus

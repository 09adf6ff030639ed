#pragma once
#include <glm/glm.hpp>

#include "sim/terrain/terrain.h"

namespace talus {

/// What a gauge shows of the sample nearest to its place.
struct GaugeReading {
    double ground_m = 0;
    double depth_m = 0;
    glm::dvec2 velocity_m_per_s{0};  ///< east, north; 0 in water thinner than what flows

    double level_m() const { return ground_m + depth_m; }
    bool operator==(const GaugeReading&) const = default;
};

/// The sample nearest to a place (m).
gpu::Region gauge_sample(const Grid& grid, double x_m, double y_m);

/// Fills in depth and velocity from a texel of the water layer.
void set_water(GaugeReading& reading, const glm::vec4& water);

/// What a gauge there shows. Waits for the device.
GaugeReading read_gauge(const Terrain& terrain, double x_m, double y_m);

/// Velocity of water of this depth (m) and discharge (m²/s), docs/numerics.md (W2).
glm::dvec2 water_velocity(double depth_m, glm::dvec2 discharge);

}  // namespace talus

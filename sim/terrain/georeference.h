#pragma once
#include <array>
#include <glm/glm.hpp>
#include <string>

#include "sim/terrain/grid.h"

namespace talus {

/// Where on Earth a heightmap lies: its coordinate system as WKT (may be empty) and GDAL's affine transform
/// from pixel corners to coordinates.
struct Georeference {
    std::string wkt;
    std::array<double, 6> transform{};
    bool operator==(const Georeference&) const = default;
};

/// Where a place on the ground (metres from the south-west sample) is in the coordinates of the file: easting
/// and northing where these are metres of a map.
glm::dvec2 coordinates_of(const Georeference& georeference, const Grid& grid, glm::dvec2 place_m);

}  // namespace talus

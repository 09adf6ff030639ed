#pragma once
#include <array>
#include <string>

namespace talus {

/// Where on Earth a heightmap lies: its coordinate system as WKT (may be empty) and GDAL's affine transform
/// from pixel corners to coordinates.
struct Georeference {
    std::string wkt;
    std::array<double, 6> transform{};
    bool operator==(const Georeference&) const = default;
};

}  // namespace talus

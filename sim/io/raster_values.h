#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/terrain/georeference.h"
#include "sim/terrain/grid.h"

namespace talus::io {

/// The numbers of a raster at the samples of a terrain.
struct RasterValues {
    std::vector<float> values;  ///< row 0 north; NaN where the raster says nothing
    std::vector<std::string> notes;
};

/// Reads a raster of one band, of any kind that GDAL reads, for a terrain of this size and place: at each
/// sample the nearest of its pixels, by the coordinate systems of both, so that classes stay what they are.
/// Where one of them says no place, the raster's outer pixels lie on the terrain's outer samples. Scale and
/// offset of its band count. Throws talus::Error that names the file where it cannot be read, has several
/// bands, lies beside the terrain, or holds what is no number.
RasterValues read_raster_values(const std::filesystem::path& path, const Grid& grid,
                                const std::optional<Georeference>& georeference);

}  // namespace talus::io

#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>

#include "sim/io/document.h"

namespace talus::io {

struct PutBackSettings {
    std::filesystem::path mosaic;  ///< the .vrt to write
    /// Within so many metres of the cut-out's edges inside the whole, work fades into the whole's heights,
    /// which stand on the edges. 0: it does not.
    double feather_m = 0;
};

/// What was written.
struct PutBack {
    std::filesystem::path patch;  ///< in a folder beside the mosaic, its name with .parts
    std::int64_t changed = 0;     ///< samples that are not the whole's
    TileSamples rectangle{};      ///< of the whole's samples that the patch holds
};

/// Puts the ground of a terrain that was cut out of a raster back into its place: writes a patch, a tiled
/// GeoTIFF with overviews that holds all tiles of 512 x 512 samples from the first to the last that changed,
/// and a mosaic (GDAL's .vrt) of the whole with the patch over it, with as many levels as the whole has. The
/// whole's files are not written to. Samples that nothing changed are the whole's, voids too. told: called
/// now and then with the share that is done; where it returns false, the work ends with nothing written, and
/// none is returned. Throws talus::Error where the terrain was not cut out, is not the whole's samples any
/// more, holds no change, or a file cannot be read or written.
std::optional<PutBack> put_back(const Document& document, const PutBackSettings& settings,
                                const std::function<bool(double)>& told);

}  // namespace talus::io

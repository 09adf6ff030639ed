#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>

#include "sim/io/document.h"

namespace talus::io {

/// How a part is put back.
struct PutBackSettings {
    std::filesystem::path mosaic;  ///< the .vrt to write
    /// Within so many metres of the cut-out's edges inside the whole, work fades into the whole's heights,
    /// which stand on the edges. 0: it does not.
    double feather_m = 0;
    /// Although the whole was changed since the part was cut out: what changed there counts as work, and
    /// goes.
    bool though_changed = false;
};

/// What was written.
struct PutBack {
    std::filesystem::path patch;  ///< in a numbered folder of one beside the mosaic, its name with .parts
    std::int64_t changed = 0;     ///< samples that are not the whole's
    TileSamples rectangle{};      ///< of the whole's samples that the patch holds
};

/// Puts the ground of a terrain that was cut out of a raster back into its place: writes a patch, a tiled
/// GeoTIFF with overviews that holds all samples from the first to the last that changed, in steps of 512
/// samples or of the coarsest level's, and a mosaic of the whole with the patch over it (sim/io/mosaic.h). A
/// mosaic that was there is replaced with its parts, at once and when all is written. The whole's files are
/// not written to. Samples that nothing changed are the whole's, voids too. told: called now and then with
/// the share that is done; where it returns false, the work ends with nothing written, and none is returned.
/// Throws talus::Error where the terrain was not cut out, has no place in the whole any more (turned,
/// resampled), or holds no change; where the whole was changed since, or holds no plain heights
/// (TiledFile::holds_plain_heights()); where the feather is below 0, or the mosaic's name does not end in
/// .vrt or is a part of the whole; where a file cannot be read or written.
std::optional<PutBack> put_back(const Document& document, const PutBackSettings& settings,
                                const std::function<bool(double)>& told);

}  // namespace talus::io

#pragma once
#include <filesystem>

#include "sim/io/tiled_file.h"

namespace talus::io {

/// A raster over a part of another one, with a level for each of that one's.
struct Patch {
    std::filesystem::path path;
    TileSamples rectangle;  ///< of the other one's samples
};

/// Where a mosaic's files go.
struct MosaicPlace {
    std::filesystem::path path;   ///< absolute, no link: its parts are named from its folder on
    std::filesystem::path as;     ///< in that folder: what it is called until it is whole
    std::filesystem::path parts;  ///< a folder for mosaics of its levels
};

/// Writes a raster and a patch over it as one raster: GDAL's .vrt, with the raster's place and as many
/// levels. A sample of a level is one of the raster's level, or of the patch's, as it is. (GDAL could make up
/// the levels of a mosaic, but only those whose sizes are powers of two fall on its parts' own samples; so
/// each level is a mosaic of its own.) Its numbers are floats, doubles where the raster's would not fit.
/// Throws talus::Error naming the file that cannot be read or written.
void write_mosaic(const TiledFile& raster, const Patch& patch, const MosaicPlace& place);

}  // namespace talus::io

#pragma once
#include <filesystem>
#include <functional>

#include "sim/io/tiled_file.h"

namespace talus::io {

/// Writes heights as a tiled GeoTIFF with overviews: BigTIFF, tiles of 512 x 512 samples, deflated with a
/// predictor. Each sample of an overview is the mean of the known ones of 2 x 2; there are overviews down to
/// one that is a single tile, and more where least_levels, the finest counted, asks for them. Reads each
/// sample once, on all cores; where a source keeps them in blocks larger than these tiles, a block may be
/// unpacked more than once. Memory does not grow with the number of rows, and hardly with that of columns.
/// Under the path stands what was there before until all is written. told: called now and then with the share
/// that is done; where it returns false, the work ends. Returns false then. Throws talus::Error naming the
/// file that cannot be read or written.
bool write_tiled(const std::filesystem::path& path, const TiledSource& source,
                 const std::function<bool(double)>& told, std::size_t least_levels = 0);

/// Writes overviews of a raster beside it, which is not written to, as write_tiled() makes them, and of which
/// content they were made. Returns and throws as write_tiled() does.
bool write_overviews(const TiledFile& raster, const std::function<bool(double)>& told);

/// Removes overviews beside a raster that write_overviews() made, and no others.
void remove_overviews(const std::filesystem::path& raster);

}  // namespace talus::io

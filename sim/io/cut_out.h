#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/io/heightmap.h"
#include "sim/io/tiled_file.h"

namespace talus::io {

/// The raster that a terrain was cut out of, the whole.
struct CutOut {
    std::filesystem::path path;     ///< absolute
    ImportSettings import;          ///< as the whole is read, without a window
    std::uint64_t fingerprint = 0;  ///< TiledFile::fingerprint() when it was cut out
};

/// As a line of JSON, for documents; and back. Throws talus::Error that names the document where that cannot
/// be read.
std::string to_text(const CutOut& cut_out);
CutOut cut_out_from(const std::filesystem::path& document, const std::string& text);

/// A part of a raster, and of which one.
struct CutOutHeights {
    Heightmap heightmap;  ///< its place is known: in metres from the whole's south-west sample where the
                          ///< whole knows no other
    CutOut cut_out;
    std::vector<float> bed_beyond;  ///< of the whole, as TerrainState has it
};
/// Reads the samples in the settings' window, moved outwards to whole samples and cut at the raster's edge,
/// of any raster that GDAL reads. Throws talus::Error where it cannot be read, or the window holds too few or
/// too many samples.
CutOutHeights cut_out_heights(const std::filesystem::path& path, const ImportSettings& settings);

/// Where the whole lies: as it says, or in metres from its south-west sample.
Georeference place_of(const TiledFile& whole);

/// Of a rectangle in metres from the whole's south-west sample: the same in the file's coordinates.
FileWindow window_of(const TiledFile& whole, glm::dvec2 south_west_m, glm::dvec2 north_east_m);

/// The whole's column and row of a terrain's first sample. None where the terrain's samples are not the
/// whole's any more: it was turned or resampled.
std::optional<glm::ivec2> first_sample_in(const TiledFile& whole, const Grid& grid,
                                          const std::optional<Georeference>& place);

}  // namespace talus::io

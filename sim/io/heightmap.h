#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sim/terrain/georeference.h"
#include "sim/terrain/grid.h"

namespace talus::io {

/// How a raw file's samples lie.
struct RawLayout {
    int nx = 0;
    int ny = 0;
    bool big_endian = false;
    bool south_first = false;
    bool operator==(const RawLayout&) const = default;
};

/// A rectangle of a raster, in the file's own coordinates (easting and northing, degrees); in metres from its
/// south-west sample where it has none.
struct FileWindow {
    double west = 0;
    double south = 0;
    double east = 0;
    double north = 0;
    bool operator==(const FileWindow&) const = default;
};

/// What a person says about a file, where its own word is not enough.
struct ImportSettings {
    std::optional<double> spacing_m;
    std::optional<glm::dvec2> range_m;  ///< heights of the smallest and the largest value of the file's type
    std::optional<RawLayout> raw;
    std::optional<FileWindow> window;  ///< the part that is cut out of it (sim/io/cut_out.h); none: all of it
    bool operator==(const ImportSettings&) const = default;
};

/// The settings as a line of JSON, for journals; and back.
std::string to_text(const ImportSettings& settings);
ImportSettings import_settings_from(const std::string& text);

/// "1025x1025", with ",big" and ",bottom" after it where they apply.
RawLayout parse_raw_layout(const std::string& text);

/// Heights of one layer, metres, row 0 north.
struct Heightmap {
    Grid grid;
    std::vector<float> heights;
    std::optional<Georeference> georeference;
    std::string kind;                ///< e.g. "GeoTIFF, 16-bit integer"
    std::vector<std::string> notes;  ///< guesses that were made and how to set them, a sentence each
};

/// How integers become heights when written: the value of 0 and of the largest integer. Heights outside are
/// clamped.
using Range = glm::dvec2;

/// Reads any single-layer format, by the file's ending (sim/io/heightmap_formats.h). Throws talus::Error
/// naming the file and what is wrong with it. Declared nodata is filled by interpolation and noted; other
/// values that are not finite are refused.
Heightmap read_heightmap(const std::filesystem::path& path, const ImportSettings& settings);

/// Writes by the ending; files that cannot hold spacing and range get a JSON sidecar. `range` sets the
/// heights of the integers 0 and 65535; without it, lowest and highest. Throws talus::Error; what was there
/// is still there then.
void write_heightmap(const std::filesystem::path& path, const Heightmap& heightmap,
                     std::optional<Range> range);

/// What is noted where --range was given for heights that are metres already.
extern const char* const range_unused;

// What the formats share.
/// Refuses a size outside of a terrain's limits before anything of it is allocated.
void check_file_size(const std::filesystem::path& path, std::int64_t nx, std::int64_t ny);
/// Turns integers from 0 to `largest` into metres: by the given range, the file's own, or the guess of an
/// eighth of the longer side, noted.
void scale_integers(Heightmap& heightmap, double largest, std::optional<Range> own,
                    const ImportSettings& settings);
/// Where all floats lie within 0 to 1: spreads them over --range, or offers that.
void scale_floats(Heightmap& heightmap, const ImportSettings& settings);
/// Refuses values that are not finite.
void check_finite(const std::filesystem::path& path, const Heightmap& heightmap);
/// 16-bit integers over a range, within half a step.
std::vector<std::uint16_t> quantise(const Heightmap& heightmap, Range range);
Range range_for(const Heightmap& heightmap, std::optional<Range> range);
/// path + ".json": spacing, range, rows and georeference of a file that cannot say them itself. Written after
/// the file and holding its hash, so that it is never believed of other content.
void write_sidecar(const std::filesystem::path& path, const Heightmap& heightmap,
                   const std::string& sample_type, std::optional<Range> range);
struct Sidecar {
    std::optional<double> dx;
    std::optional<double> dy;
    std::optional<Range> range;
    std::optional<RawLayout> raw;
    std::optional<Georeference> georeference;
};
/// The sidecar of a file as it is now; none where there is none or it belongs to other content, which is
/// noted.
std::optional<Sidecar> read_sidecar(const std::filesystem::path& path, std::vector<std::string>& notes);

}  // namespace talus::io

#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/io/heightmap.h"
#include "sim/tiled/tile_bounds.h"

namespace talus::io {

/// Metadata of a file, in a domain of Talus's own, that says where samples of its levels stand.
constexpr const char* levels_domain = "TALUS";
constexpr const char* levels_item = "LEVELS";
constexpr const char* levels_by_halves = "means of 2 x 2";
/// In overviews beside a raster: of which content they were made (TiledFile::content_mark()).
constexpr const char* made_of_item = "MADE_OF";

/// Types that tiled files are written with.
enum class SampleType { byte, uint16, int16, float32 };

/// Heights of any number, to be read in parts.
struct TiledSource {
    Grid grid;
    std::optional<Georeference> georeference;
    SampleType samples = SampleType::float32;
    std::optional<float> void_value;  ///< stands in a file for samples that are not known
    bool in_rows = false;             ///< whole rows are read at the least cost
    /// Makes a reader of level 0; samples that are not known are NaN. Each belongs to one thread.
    std::function<ReadSamples()> make_reader;
};

/// A raster of any size and format that GDAL reads, its overviews the levels of a tiled terrain.
class TiledFile {
  public:
    /// Opens it and reads what it says of itself. Throws talus::Error naming the file and what is wrong.
    TiledFile(const std::filesystem::path& path, const ImportSettings& settings);

    const std::filesystem::path& path() const { return path_; }
    const Grid& grid() const { return source_.grid; }
    const std::optional<Georeference>& georeference() const { return source_.georeference; }
    /// Samples of the levels, the finest first: its overviews as far as each halves the one before.
    const std::vector<glm::ivec2>& levels() const { return levels_; }
    /// Where their samples stand: as `talus tile` wrote them, else as most writers of overviews do.
    LevelPlaces level_places() const { return level_places_; }
    const std::string& kind() const { return kind_; }  ///< e.g. "GTiff, Int16"
    const std::vector<std::string>& notes() const { return notes_; }
    /// Changes with the finest level's content, as its folder tells it: of names, sizes and times of all
    /// files that it is made of, parts of parts too, and how its numbers become heights. How its path is
    /// written does not matter.
    std::uint64_t fingerprint() const { return fingerprint_; }
    /// Changes with the fingerprint and with overviews that lie beside the files.
    std::uint64_t levels_fingerprint() const { return levels_fingerprint_; }

    /// Whether its numbers are heights in metres as they stand, its first row the north one and its first
    /// column the west one.
    bool holds_plain_heights() const { return plain_heights_; }

    /// Whether it, or a part of it, is another one than when it was opened, as its folder tells it. False
    /// where that cannot be found out.
    bool has_changed() const;

    /// A reader of all levels for one thread. Samples that are not known lie as high as the next coarser
    /// level where that knows them; in the coarsest, as means of ever larger parts of it have it. It throws
    /// talus::Error naming the file.
    ReadSamples make_reader() const;
    /// Its finest level as it is.
    const TiledSource& source() const { return source_; }
    /// Its finest level as the file stores it, to make overviews of: rows and columns in its own order,
    /// numbers as they stand in it. It lies nowhere.
    TiledSource stored() const;
    /// Its overviews, also such as are no levels(). outdated: they lie beside it, and Talus made them of
    /// another content; they are no levels().
    enum class Overviews { none, some, outdated };
    Overviews overviews() const { return overviews_; }
    /// What overviews that are made of it note of its content. Copies and other names do not change it;
    /// overviews that are older than a file that it is made of are outdated too.
    const std::string& content_mark() const { return content_mark_; }
    /// Why overviews of one band, in floats, would mislead other programs; empty: they would not.
    const std::string& why_no_overviews() const { return why_no_overviews_; }

  private:
    std::filesystem::path path_;
    TiledSource source_;
    std::vector<glm::ivec2> levels_;
    LevelPlaces level_places_ = LevelPlaces::by_count;
    std::string kind_;
    std::vector<std::string> notes_;
    std::uint64_t fingerprint_ = 0;
    std::uint64_t levels_fingerprint_ = 0;
    std::string content_mark_;
    std::string why_no_overviews_;
    bool plain_heights_ = true;
    Overviews overviews_ = Overviews::none;
    SampleType stored_samples_ = SampleType::float32;
    std::string parts_;  // names, sizes and times of all files that it is made of, and of their overviews
    struct Reading;
    static ReadSamples reader_of(const std::shared_ptr<const Reading>& reading);
    std::shared_ptr<const Reading> reading_;
};

/// Whether writing to a file would change a raster: it is the raster's, or one that it lists as its part, or
/// a part of one. Throws talus::Error where the raster cannot be opened.
bool is_made_of(const std::filesystem::path& raster, const std::filesystem::path& file);

/// Where GDAL looks for overviews of a raster that has none in itself: its path + ".ovr".
std::filesystem::path overviews_path(const std::filesystem::path& raster);

/// Memory that reading may keep of rasters, all files and threads together, bytes.
void limit_read_memory(std::size_t bytes);
/// From now on what reading lets go of goes back to the system at once. It takes time: for who reads as long
/// as a window is open, not for who writes one file.
void return_read_memory();
/// Memory that it keeps of them now, bytes.
std::size_t read_memory_bytes();

/// Whether a file is a raster of more samples than a terrain that is held as a whole may have
/// (sim/terrain/grid.h). False where GDAL does not open it.
bool is_larger_than_a_terrain(const std::filesystem::path& path);

}  // namespace talus::io

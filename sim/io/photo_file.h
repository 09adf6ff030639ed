#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/terrain/georeference.h"
#include "sim/tiled/photo.h"

namespace talus::io {

/// A raster in colours of any size, to be laid over a terrain: one, three or four bands of 8 or 16 bits, or
/// colours of a table. What its alpha band, mask or nodata leaves out is not covered.
class PhotoFile {
  public:
    /// Opens it, turned and warped into the ground's coordinate system where it has another one. ground:
    /// where that lies on Earth. Throws talus::Error naming the file and what is wrong; also where it is
    /// large and has no overviews.
    PhotoFile(const std::filesystem::path& path, const std::optional<Georeference>& ground);

    const std::filesystem::path& path() const { return path_; }
    glm::ivec2 texels() const { return texels_; }  ///< in a row and in a column
    /// Whether the photo and the ground say where they lie; else it is stretched over all of the ground.
    bool is_placed() const { return is_placed_; }
    /// Whether it covers all of a ground of this place and size, without leaving anything out.
    bool covers(const Grid& ground, const std::optional<Georeference>& georeference) const;
    /// Where it lies over a ground of this place and size, in the ground's coordinate system. Throws
    /// talus::Error where it lies beside it.
    PhotoPlace place_over(const Grid& ground, const std::optional<Georeference>& georeference) const;

    /// A reader of all levels (photo_tree()) for one thread.
    ReadTexels make_reader() const;

  private:
    std::filesystem::path path_;
    std::optional<Georeference> ground_;
    glm::ivec2 texels_{0};
    bool is_placed_ = false;
    bool is_whole_ = false;              // it leaves nothing out
    std::array<double, 6> transform_{};  // of the photo, where it is placed
};

/// Throws talus::Error where a file cannot be read, or holds no colours that a photo can have.
void check_colours(const std::filesystem::path& path);

/// Whether a file is to be opened so: it says where on Earth it lies, as the ground does, or it has more
/// texels a side than a picture that is held as a whole. False where GDAL does not open it.
bool is_photo(const std::filesystem::path& path, bool ground_is_placed);

}  // namespace talus::io

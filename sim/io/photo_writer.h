#pragma once
#include <filesystem>
#include <functional>

namespace talus::io {

/// Writes a raster in colours (sim/io/photo_file.h) so that it is looked at without reading all of it: a
/// BigTIFF in tiles of 512 x 512, deflated, with overviews, each texel about the mean light of those of 2
/// x 2. Colours, place and what is not covered stay as they are; a table's colours become bands. Under the
/// path stands what was there before until all is written. told: called now and then with the share that is
/// done; where it returns false, the work ends. Returns false then. Throws talus::Error naming the file that
/// cannot be read or written.
bool write_photo(const std::filesystem::path& photo, const std::filesystem::path& path,
                 const std::function<bool(double)>& told);

}  // namespace talus::io

#pragma once
#include <filesystem>
#include <optional>
#include <vector>

#include "sim/io/tiled_file.h"

namespace talus::io {

/// Where the bounds of a tiled file's tiles are kept: its path + ".tiles".
std::filesystem::path tile_sidecar_path(const std::filesystem::path& path);

/// Writes the bounds of all tiles beside the file. Throws talus::Error where it cannot.
void write_tile_sidecar(const TiledFile& file, const TileTree& tree, const std::vector<TileBounds>& bounds);

/// The bounds that were written for this file as it is now and for such a tree; none where there are none,
/// where the file changed since, or where they are damaged: they are to be measured then.
std::optional<std::vector<TileBounds>> read_tile_sidecar(const TiledFile& file, const TileTree& tree);

}  // namespace talus::io

#pragma once
#include <string>
#include <vector>

#include "sim/io/tiled_file.h"

namespace talus::app {

/// Patches of the finest level in a row of a tile.
constexpr int tile_patches = 256;

/// A file of tiles with what is known of them.
struct TiledTerrain {
    io::TiledFile file;
    TileTree tree;
    std::vector<TileBounds> bounds;
    std::vector<std::string> notes;
    float lowest_m = 0;
    float highest_m = 0;
};

/// Lowest and highest sample of all tiles.
glm::vec2 heights_of(const std::vector<TileBounds>& bounds);

/// Opens it; the bounds of its tiles come from the file beside it, or are measured and kept there. Throws
/// talus::Error where it cannot be read, has no levels to fly over, or the work was ended by Ctrl+C.
TiledTerrain open_tiled(const std::string& path, const io::ImportSettings& import);

}  // namespace talus::app

#pragma once
#include <cstddef>
#include <filesystem>
#include <string>

#include "sim/tiled/tile_tree.h"

namespace talus::app {

/// Memory of the device that tiles may take, and where that was said.
struct TileRoom {
    std::string parameter;  ///< e.g. "tiles.gpu_mib"
    int mib = 0;
    std::filesystem::path file;  ///< whose tiles they are
};

/// Slots that fit into it beside what the tree itself takes, and not more than a surface has a use for.
/// Throws talus::Error where they are too few.
int slots_within(const TileRoom& room, const TileTree& tree, std::size_t bytes_of_slot);

}  // namespace talus::app

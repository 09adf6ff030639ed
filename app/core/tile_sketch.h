#pragma once
#include "app/core/tiled_terrain.h"

namespace talus::app {

/// What can be shown of a file within about a second, before anything of it is measured: where it has levels,
/// those, with guesses for bounds; else heights of a few of its samples, and what lies between them
/// interpolated. Throws talus::Error where the file cannot be read, or cannot be made ready either
/// (open_tiled()).
TiledTerrain sketch_of(io::TiledFile file);

}  // namespace talus::app

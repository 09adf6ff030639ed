#pragma once
#include <string>

#include "app/core/tiled_terrain.h"

namespace talus::app {

/// A terrain in tiles that can be shown within about a second, before anything of it is measured: where the
/// file has levels, those, with guesses for bounds; else heights of a few of its samples, and what lies
/// between them interpolated. Throws talus::Error where the file cannot be read, or cannot be made ready
/// either (open_tiled()).
TiledTerrain sketch_tiled(const TiledRequest& request);

}  // namespace talus::app

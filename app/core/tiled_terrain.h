#pragma once
#include <functional>
#include <string>
#include <vector>

#include "app/core/progress.h"
#include "app/core/scene.h"
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

/// Whether it is looked at in tiles: it asks for that, or its file is too large to be held as a whole.
bool is_in_tiles(const SceneRequest& request);

/// How measuring a file's tiles is told on stderr, and ended by Ctrl+C (app/core/long_work.h).
std::function<Progress(const std::string& path)> on_terminal();

/// Opens it; the bounds of its tiles come from the file beside it, or are measured and kept there, which
/// takes long: then `begin_progress` is asked for whom to tell. Throws talus::Error where it cannot be read,
/// has no levels to fly over, or the work was ended.
TiledTerrain open_tiled(const std::string& path, const io::ImportSettings& import,
                        const std::function<Progress(const std::string& path)>& begin_progress);

/// Whether open_tiled() has no long work with what a request asks for: the bounds are beside the file. Throws
/// as open_tiled() does.
bool is_measured(const SceneRequest& request);

/// Slots that fit into so much memory of the device. Throws talus::Error where they are too few.
int slots_within(const TiledTerrain& terrain, int gpu_mib);

/// The scene that a window opens: of a request that is_in_tiles() one to look at, else one to work in
/// (make_scene()).
Scene open_scene(const SceneRequest& request,
                 const std::function<Progress(const std::string& path)>& begin_progress);

}  // namespace talus::app

#pragma once
#include "app/core/scene.h"
#include "app/core/tiled_terrain.h"

namespace talus::app {

/// Whether what is asked for is looked at in tiles: it says so, or its file is a mosaic (.vrt), or too large
/// to be held as a whole. A window of a file is not.
bool is_in_tiles(const SceneRequest& request);

/// Whether opening takes long: tiles, of what is asked for or stands around it, are not measured yet. Throws
/// talus::Error where what is_in_tiles() cannot be opened.
bool is_to_be_measured(const SceneRequest& request);

/// Throws talus::Error where a request that is_in_tiles() asks for what a terrain in tiles has not: a preset,
/// parameters of simulations, a method, views of layers.
void check_tiled_request(const SceneRequest& request);

/// A terrain in tiles, and the parameters that it is looked at with.
struct TiledScene {
    std::shared_ptr<const TiledTerrain> terrain;
    SceneParameters parameters;
    io::ColourImage texture;  ///< draped over it; without pixels: none
};
/// Opens what a request asks for that is_in_tiles(). Throws talus::Error where the file cannot be opened
/// (open_tiled()), and as check_tiled_request() does.
TiledScene open_tiled_scene(const SceneRequest& request,
                            const std::function<Progress(const std::string& path)>& begin_progress);

/// Opens what the scene's terrain was cut out of, for pictures (`tiles.backdrop`). Where that cannot be
/// shown, a note of the document says why.
void open_whole(Scene& scene, const std::function<Progress(const std::string& path)>& begin_progress);

/// The scene that a window opens: one in tiles, or one to work in (make_scene()).
Scene open_scene(const SceneRequest& request,
                 const std::function<Progress(const std::string& path)>& begin_progress);

}  // namespace talus::app

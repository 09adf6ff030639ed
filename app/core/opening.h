#pragma once
#include "app/core/scene.h"

namespace talus::app {

/// Whether what is asked for is looked at in tiles: it says so, or its file is a mosaic (.vrt), or too large
/// to be held as a whole. A window of a file is not.
bool is_in_tiles(const SceneRequest& request);

/// Throws talus::Error where a request that is_in_tiles() asks for what a terrain in tiles has not: a preset,
/// parameters of simulations, a method, views of layers.
void check_tiled_request(const SceneRequest& request);

/// A terrain in tiles, and the parameters that it is looked at with.
struct TiledScene {
    std::shared_ptr<const TiledTerrain> terrain;
    SceneParameters parameters;
    Draping draping;
};
/// Opens what a request asks for that is_in_tiles(). Throws talus::Error where the file cannot be opened
/// (open_tiled()), and as check_tiled_request() does.
TiledScene open_tiled_scene(const SceneRequest& request, const BeginProgress& begin_progress);

/// The scene that is looked at: one in tiles, or one to work in (make_scene()) with what it was cut out of
/// around it (`tiles.backdrop`); where that cannot be shown, a note of the document says why. What is to be
/// made ready takes long (open_tiled()), but no overviews are made of what stands around a scene. Throws
/// talus::Error where the scene cannot be opened.
Scene open_scene(const SceneRequest& request, const BeginProgress& begin_progress);

/// The same without long work, for a window: tiles that are not measured yet are a sketch, and those around a
/// scene too or, without levels, not there yet. Then `Scene::unready` is what open_tiled() is to make ready.
Scene open_scene_at_once(const SceneRequest& request);

/// The scene's terrain was cut out of this one, which is to be shown around it. Returns what is to be noted
/// of that.
std::vector<std::string> take_whole(Scene& scene, TiledTerrain terrain);

}  // namespace talus::app

#pragma once
#include <functional>
#include <string>
#include <vector>

#include "app/core/progress.h"
#include "sim/io/cut_out.h"
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

/// How measuring a file's tiles is told on stderr, and ended by Ctrl+C (app/core/long_work.h).
std::function<Progress(const std::string& path)> on_terminal();

/// Opens it; the bounds of its tiles come from the file beside it, or are measured and kept there, which
/// takes long: then `begin_progress` is asked for whom to tell. Throws talus::Error where it cannot be read,
/// has no levels to fly over, or the work was ended.
TiledTerrain open_tiled(const std::string& path, const io::ImportSettings& import,
                        const std::function<Progress(const std::string& path)>& begin_progress);

/// Whether open_tiled() has no long work: the bounds are beside the file. Throws as it does.
bool is_measured(const std::string& path, const io::ImportSettings& import);

/// After a part was put back into what it was cut out of: keeps the bounds of the mosaic's tiles beside it,
/// so that it opens at once. They are those of the whole, but where the patch is. Where the whole was not
/// measured, or has voids, which are filled from afar, nothing is kept, and the mosaic is measured when it is
/// opened.
void keep_bounds_of_mosaic(const io::CutOut& whole, const std::string& mosaic, const TileSamples& patch);

/// Slots that fit into so much memory of the device. Throws talus::Error where they are too few.
int slots_within(const TiledTerrain& terrain, int gpu_mib);

}  // namespace talus::app

#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/core/progress.h"
#include "sim/io/cut_out.h"
#include "sim/io/tiled_file.h"

namespace talus::app {

/// Patches of the finest level in a row of a tile.
constexpr int tile_patches = 256;

/// A file that is looked at in tiles, and how it is read.
struct TiledRequest {
    std::string path;
    io::ImportSettings import;
};
/// Whether both are of the same file, however its path is written, read the same way.
bool is_same(const TiledRequest& a, const TiledRequest& b);

/// A file of tiles with what is known of them.
struct TiledTerrain {
    io::TiledFile file;
    TileTree tree;
    std::vector<TileBounds> bounds;
    std::vector<std::string> notes;
    float lowest_m = 0;
    float highest_m = 0;
    bool is_measured = true;  ///< false: a sketch (app/core/tile_sketch.h), whose bounds are guesses
    /// Of a sketch of a file without levels: reads heights of all levels in its place, on any thread.
    ReadSamples instead{};

    /// A reader of all levels for one thread.
    ReadSamples make_reader() const { return instead ? instead : file.make_reader(); }
};

/// Lowest and highest sample of all tiles.
glm::vec2 heights_of(const std::vector<TileBounds>& bounds);

/// Whether a file has too few levels to be shown as a whole, and overviews can be made beside it. Throws
/// talus::Error where they cannot: it has some, a file has their name, or they would mislead other programs.
bool needs_overviews(const io::TiledFile& file);

/// Its tiles. Throws talus::Error where it has too few levels to be shown as a whole.
TileTree tree_of(const io::TiledFile& file);

/// Asked for whom to tell of long work, by what it is ("measuring the tiles of 'alps.tif'").
using BeginProgress = std::function<Progress(const std::string& what)>;

/// Tells on stderr; Ctrl+C ends the work (app/core/long_work.h).
BeginProgress on_terminal();

/// Makes overviews of a file that needs them, beside it (io::write_overviews()). Throws talus::Error where
/// they cannot be written, and Interrupted.
void make_overviews(const io::TiledFile& file, const BeginProgress& begin_progress);

/// Opens it. Overviews that it needs are made (make_overviews()), and the bounds of its tiles come from the
/// file beside it, or are measured and kept there. Throws talus::Error where the file cannot be read, or its
/// overviews not written, and Interrupted.
TiledTerrain open_tiled(const TiledRequest& request, const BeginProgress& begin_progress);

/// A file that was opened with what is known of its tiles; none where that is to be made or measured first.
/// Throws as needs_overviews() does.
std::optional<TiledTerrain> ready_of(const io::TiledFile& file);

/// After a part was put back into what it was cut out of: keeps the bounds of the mosaic's tiles beside it,
/// so that it opens at once. They are those of the whole, but where the patch is. Where the whole was not
/// measured, or has voids, which are filled from afar, nothing is kept, and the mosaic is measured when it is
/// opened.
void keep_bounds_of_mosaic(const io::CutOut& whole, const std::string& mosaic, const TileSamples& patch);

/// Slots that fit into `tiles.gpu_mib`. Throws talus::Error naming it where they are too few.
int slots_within(const TiledTerrain& terrain, int gpu_mib);

}  // namespace talus::app

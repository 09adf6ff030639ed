#pragma once
#include <vector>

#include "render/tiled/tiled_surface.h"

namespace talus::render {

/// Reads tiles that a surface wants, with as many threads as there are readers.
class TileLoading {
  public:
    /// make_reader: called once for each thread.
    explicit TileLoading(const std::function<ReadSamples()>& make_reader);

    /// Puts the coarsest tiles on the device, which must be there before anything is looked at.
    void begin(TiledSurface& surface);
    /// Looks, and puts all tiles on the device that the picture wants. Throws talus::Error where one cannot
    /// be read.
    const TileChoice& load(TiledSurface& surface, const Camera& camera, glm::ivec2 size, double tolerance_px);

  private:
    void put(TiledSurface& surface, const std::vector<TileId>& tiles);

    std::vector<ReadSamples> readers_;
};

}  // namespace talus::render

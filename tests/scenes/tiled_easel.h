#pragma once
#include <vector>

#include "render/hits_target.h"
#include "render/tiled/tiled_rays.h"
#include "tests/scenes/load_tiles.h"

namespace talus::scenes {

/// Draws pictures of a tiled terrain.
class TiledEasel {
  public:
    TiledEasel(const MemoryTiles& tiles, glm::ivec2 size, int slots)
        : surface(tiles.tree(), tiles.bounds(), slots), tiles_(tiles), size_(size), target_(size.x, size.y) {
        put_coarsest(surface, tiles);
    }

    void put(const TileId& tile) { surface.put(tile, tiles_.read(tile)); }

    /// Until all tiles are there that the picture wants.
    render::TileChoice load(const render::Camera& camera, double tolerance_px) {
        return load_tiles(surface, tiles_, camera, size_, tolerance_px);
    }

    /// Of what was looked at last.
    std::vector<float> distances(const render::Camera& camera) {
        rays_.cast(surface, camera, size_, target_.framebuffer());
        return target_.read_distances(size_.x, size_.y);
    }
    /// Slots of the tiles that its pixels hit.
    std::vector<float> hit_slots() { return target_.read_details(size_.x, size_.y); }

    render::TiledSurface surface;

  private:
    const MemoryTiles& tiles_;
    glm::ivec2 size_;
    render::HitsTarget target_;
    render::TiledRays rays_{render::Detail::none};
};

}  // namespace talus::scenes

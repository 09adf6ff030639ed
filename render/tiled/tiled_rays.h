#pragma once
#include "render/methods/ray_casting.h"
#include "render/tiled/tiled_surface.h"

namespace talus::render {

/// Casts a ray for every pixel over a terrain in tiles.
class TiledRays {
  public:
    /// The detail of the hits (render/methods/method.h): steps, or else the slot of the tile that was hit.
    explicit TiledRays(Detail detail);

    /// Fills the hits from what the surface looked at last, from the same eye; the camera's window may be
    /// another.
    void cast(const TiledSurface& surface, const Camera& camera, glm::ivec2 size,
              const gpu::Framebuffer& hits);

  private:
    RayCasting rays_;
};

}  // namespace talus::render

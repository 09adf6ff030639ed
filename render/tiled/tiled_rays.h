#pragma once
#include <optional>

#include "render/methods/ray_casting.h"
#include "render/tiled/tiled_surface.h"

namespace talus::render {

/// Sets the uniforms of shaders/render/tile_hole.glsl.
void set_hole(gpu::Program& program, glm::ivec2 first, glm::ivec2 end);

/// Casts a ray for every pixel over a terrain in tiles.
class TiledRays {
  public:
    /// The detail of the hits (render/methods/method.h): steps, or else the slot of the tile that was hit.
    explicit TiledRays(Detail detail);
    /// Around a hole of these patches, from the first to before the end. The detail of hits on its walls is
    /// minus the slot and 1.
    TiledRays(glm::ivec2 hole_first, glm::ivec2 hole_end);

    /// Fills the hits from what the surface looked at last, from the same eye; the camera's window may be
    /// another.
    void cast(const TiledSurface& surface, const Camera& camera, glm::ivec2 size,
              const gpu::Framebuffer& hits);

  private:
    struct Hole {
        glm::ivec2 first;
        glm::ivec2 end;
    };
    std::optional<Hole> hole_;
    std::vector<std::string> defines_;
    RayCasting rays_;
    std::optional<gpu::Program> parallel_;  // of parallel views, once there was one
};

}  // namespace talus::render

#pragma once
#include "render/camera.h"
#include "sim/gpu/program.h"
#include "sim/gpu/texture.h"
#include "sim/terrain/reshape.h"

namespace talus::render {

/// Lays a rectangle's edge over a picture of ground.
class Outline {
  public:
    Outline();

    /// colours, hits: of the picture of this size. ground: what of the picture is ground; beyond are the
    /// terrain's sides.
    void draw(const gpu::Texture& colours, const gpu::Texture& hits, const Grid& grid, const Camera& camera,
              glm::ivec2 size, const Rectangle& rectangle, const Rectangle& ground);
    /// What was drawn last.
    const gpu::Framebuffer& framebuffer() const { return buffer_; }

  private:
    gpu::Program program_;
    gpu::Texture colour_;
    gpu::Framebuffer buffer_;
};

}  // namespace talus::render

#pragma once
#include <glm/glm.hpp>

#include "render/camera.h"
#include "render/pyramid.h"

namespace talus::render {

/// The blocks of a picture (render/blocks.h) that a change of the terrain may touch. Marked, listed and drawn
/// on the device; all other pixels would keep their bits (law 2).
class Redraw {
  public:
    Redraw();

    /// Forgets all marks; of a picture of this size.
    void begin(int width, int height);
    /// Marks the blocks that listed tiles cover, by the pyramid's present bounds, with the tiles' shadows and
    /// the ground around them whose shading reads them. Call it before the pyramid is rebuilt, and again
    /// after. If the terrain's lowest or highest sample changed in between, marks all blocks. sun: unit
    /// vector towards it; 0: no shadows. reach: samples around a place that its colours read.
    void mark(bool after, const TileList& tiles, const Terrain& terrain, const Pyramid& pyramid,
              const Camera& camera, glm::dvec3 sun, int reach);
    /// For shaders that find more to draw: shaders/render/redraw_marks.glsl.
    void bind(gpu::Program& program) const;
    /// Lists the marked blocks; draws before the next list() use it.
    void list();
    /// Draws the marked blocks, with a program of block.vert.
    void draw(gpu::Program& program, const gpu::Framebuffer& target, gpu::Depth depth) const;

  private:
    int width_ = 0;
    int height_ = 0;
    glm::ivec2 blocks_{0};
    gpu::Program mark_;
    gpu::Program list_;
    gpu::Buffer marks_;
    gpu::Buffer listed_;
};

}  // namespace talus::render

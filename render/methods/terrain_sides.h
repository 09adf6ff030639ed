#pragma once
#include "render/methods/method.h"

namespace talus::render {

/// What triangles over the ground leave out, because the ground is solid: the terrain's sides, and everything
/// where the eye is below the ground.
class TerrainSides {
  public:
    /// Draws the nearest into the frame's hits.
    void draw(const Frame& frame);
    /// Without the sides.
    void draw_below(const Frame& frame);

  private:
    void prepare(gpu::Program& program, const Frame& frame);

    gpu::Program walls_{std::vector<std::string>{"render/mesh_walls.vert", "render/mesh.frag"}, {"WALLS"}};
    gpu::Program below_{std::vector<std::string>{"render/mesh_below.vert", "render/mesh_below.frag"}};
    gpu::Buffer arguments_{"arguments of the terrain's sides", 8 * sizeof(std::uint32_t)};
};

}  // namespace talus::render

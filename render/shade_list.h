#pragma once
#include <glm/glm.hpp>

#include "render/blocks.h"
#include "sim/gpu/buffer.h"
#include "sim/gpu/program.h"
#include "sim/gpu/texture.h"

namespace talus::render {

/// Lists the blocks of a picture in which rays hit something, and those in which none did, so that each kind
/// is coloured by a shader of its own: software runs all of a shader for every pixel that it is drawn over.
class ShadeList {
  public:
    ShadeList() : program_("render/shade_list.comp") {}

    /// From a picture's hits: infinite where there are none. skips_walls: those with a detail below 0 are
    /// none too.
    void make(const gpu::Texture& hits, int width, int height, bool skips_walls = false);
    BlockList nothing() const;
    BlockList something() const;

  private:
    gpu::Program program_;
    gpu::Buffer words_;
    std::size_t blocks_ = 0;
};

}  // namespace talus::render

#pragma once
#include "render/methods/method.h"

namespace talus::render {

/// A terrain's heights at ever wider spacing, each level filtered from the finer one by weights 1, 2, 1 over
/// 4 (Losasso & Hoppe 2004 leave the filter open). Level 0 is the ground itself; level l has a sample at
/// every 2^l-th column and row, and its last ones lie on the terrain's far edges.
class HeightLevels {
  public:
    /// Finds again what hangs on the listed tiles of the terrain.
    void refresh(const Terrain& terrain, int levels, const TileList& changed);
    /// Binds the levels as `height_levels`, and where two of them lie in it: `offset` and `coarser_offset`.
    void bind(gpu::Program& program, int level) const;
    std::size_t bytes() const { return sizeof(float) * image_.width() * image_.height(); }

  private:
    /// Of a level from 1 on, in the image.
    glm::ivec2 offset(int level) const;
    glm::ivec2 size(int level) const;

    gpu::Program program_{"render/height_levels.comp"};
    gpu::Texture image_;
    glm::ivec2 patches_{0};
    int levels_ = 0;
};

}  // namespace talus::render

#pragma once
#include "sim/gpu/program.h"
#include "sim/gpu/texture.h"
#include "sim/terrain/terrain.h"

namespace talus {

/// The highest and lowest sample of blocks of patches: level l covers 2^l x 2^l patches, from level 1 up to
/// top_level(); level 0 is a patch's four samples and is not stored. Mip level l - 1 of a texture is level l.
/// Cells without a patch hold -infinity and infinity.
class Pyramid {
  public:
    /// Allocates; nothing is built before the first refresh().
    explicit Pyramid(const Terrain& terrain);

    /// Rebuilds the cells over tiles whose surface mark is set, in this terrain, and clears the mark.
    void refresh(Terrain& terrain);

    int top_level() const { return highest.levels(); }
    std::size_t bytes() const;

    gpu::Texture highest;
    gpu::Texture lowest;

  private:
    struct Half {
        gpu::Program low_levels;
        gpu::Program high_levels;
    };
    void refresh(Half& half, gpu::Texture& bounds, const Terrain& terrain);

    Half max_;
    Half min_;
    TileList dirty_;
};

}  // namespace talus

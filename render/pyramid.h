#pragma once
#include "sim/gpu/program.h"
#include "sim/gpu/texture.h"
#include "sim/terrain/terrain.h"

namespace talus::render {

/// The highest and lowest sample of blocks of patches: level l covers 2^l x 2^l patches, from level 1 up to
/// top_level(); level 0 is a patch's four samples and is not stored. Cells without a patch hold -infinity and
/// infinity. All levels lie in one image, as shaders/render/pyramid_layout.glsl says.
class Pyramid {
  public:
    /// Over the terrain's ground. Allocates; nothing is built before the first refresh().
    explicit Pyramid(const Terrain& terrain);
    /// Over another surface of the same samples, which hangs on these kinds of change (Tiles::Change) in a
    /// tile and its neighbours.
    Pyramid(const Terrain& terrain, const gpu::Texture& surface, std::uint32_t changes);

    /// Lists the tiles that changed since it was called last, and those around them whose patches use their
    /// samples.
    const TileList& list_changes(const Terrain& terrain);
    /// Rebuilds the cells over the tiles listed last.
    void rebuild(const Terrain& terrain);
    void refresh(const Terrain& terrain) {
        list_changes(terrain);
        rebuild(terrain);
    }

    int top_level() const { return top_level_; }
    glm::ivec2 level_1_size() const { return level_1_size_; }
    std::size_t bytes() const { return 2 * sizeof(float) * highest.width() * highest.height(); }
    /// Binds the max pyramid and the surface under it for shaders/render/surface.glsl and sets its uniforms.
    void bind(gpu::Program& program, const Terrain& terrain) const;

    gpu::Texture highest;
    gpu::Texture lowest;

  private:
    Pyramid(const Terrain& terrain, const gpu::Texture* surface, std::uint32_t changes);
    const gpu::Texture& surface_of(const Terrain& terrain) const {
        return surface_ ? *surface_ : terrain.ground;
    }

    const gpu::Texture* surface_;  // none: the terrain's ground
    std::uint32_t changes_;
    Tiles::Reader read_;
    int top_level_;
    glm::ivec2 level_1_size_;
    gpu::Program low_levels_;
    gpu::Program high_levels_;
    TileList dirty_;
};

}  // namespace talus::render

#pragma once
#include "render/methods/method.h"

namespace talus::render {

namespace glsl {
#include "render/envelope.glsl"
}  // namespace glsl

/// The outer mesh over a terrain, by blocks of 9 x 9 samples: each sample raised to the highest of the 3 x 3
/// around it, those that blocks share not (Jeong & Han 2006, section 4). With its squares split along their
/// higher diagonals it lies nowhere under the bilinear surface.
class Envelope {
  public:
    /// Of the terrain as it is now: what changed is made again.
    void refresh(const Terrain& terrain);
    /// Heights of the samples, m.
    const gpu::Texture& heights() const { return heights_; }
    /// A whole number a tile, above 0, that changes whenever the tile is made again.
    const gpu::Buffer& versions() const { return versions_; }
    std::size_t bytes() const {
        return sizeof(float) * heights_.width() * heights_.height() + versions_.bytes();
    }

  private:
    gpu::Program program_{"render/envelope.comp"};
    gpu::Texture heights_;
    gpu::Buffer versions_;
    std::unique_ptr<TileList> changed_;
    Tiles::Reader read_;
};

}  // namespace talus::render

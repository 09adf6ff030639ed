#pragma once
#include "render/pyramid.h"

namespace talus::render {

/// How much of the sky each square of 4 x 4 patches sees past the ground around it, 0 to 1: eight directions,
/// each to the steepest of four cells of the pyramid up to 40 samples away. Kept up to date by tiles, like
/// the pyramid.
class SkyView {
  public:
    explicit SkyView(const Terrain& terrain);

    /// Makes the squares anew whose surroundings changed; the pyramid must be up to date.
    void refresh(const Terrain& terrain, const Pyramid& pyramid);
    const gpu::Texture& share() const { return share_; }
    std::size_t bytes() const { return sizeof(float) * share_.width() * share_.height(); }

  private:
    gpu::Program program_;
    gpu::Texture share_;
    TileList dirty_;
    Tiles::Reader read_;
};

}  // namespace talus::render

#pragma once
#include "render/hits_target.h"
#include "render/methods/method.h"
#include "render/pyramid.h"

namespace talus::render {

/// The water's surface, the second surface that rays are cast onto. At wet samples it is ground + depth. At
/// dry samples beside water the mean level of that water is extended below the ground, so that the shoreline
/// lies where level and bilinear ground meet. Elsewhere it is far below (docs/numerics.md, "Seeing water").
class WaterSurface {
  public:
    /// The terrain must have a water layer.
    explicit WaterSurface(const Terrain& terrain);
    WaterSurface(const WaterSurface&) = delete;
    WaterSurface& operator=(const WaterSurface&) = delete;

    /// Brings level and pyramid up to date with the tiles whose water or ground changed.
    void refresh(const Terrain& terrain);
    /// Casts every pixel's ray onto the water, exactly.
    void cast(const Terrain& terrain, const Camera& camera, int width, int height);

    const gpu::Texture& level() const { return level_; }
    /// Distances as in Frame::hits, of the water alone.
    const HitsTarget& target() const { return target_; }

  private:
    gpu::Texture level_;  // m
    gpu::Program program_;
    Pyramid pyramid_;
    Method method_;
    Method parallel_;
    HitsTarget target_;
};

}  // namespace talus::render

#pragma once
#include "render/shade_list.h"
#include "render/shading.h"
#include "render/water_surface.h"

namespace talus::render {

/// Lays the water over a picture of the ground: the bed seen by refraction, dimmed by the way through the
/// water, and sky and terrain reflected (docs/numerics.md, "Seeing water").
class WaterShading {
  public:
    WaterShading();

    /// The frame's hits and the colours are the ground's; the water must have been cast for the same camera.
    /// extent_m: as of the ground, for the haze.
    void draw(const ShadeFrame& frame, const Terrain& terrain, const Pyramid& pyramid,
              const WaterSurface& water, const gpu::Texture& colours, double extent_m);

  private:
    ShadeList list_;
    gpu::Program dry_;  // where there is no water: the ground as it is
    gpu::Program mirroring_;
    gpu::Program quick_;
};

}  // namespace talus::render

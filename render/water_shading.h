#pragma once
#include "render/camera.h"
#include "render/pyramid.h"
#include "render/shade_list.h"
#include "render/view.h"
#include "render/water_surface.h"

namespace talus {

/// Lays the water over a picture of the ground: the bed seen by refraction, dimmed by the way through the
/// water, and sky and terrain reflected (docs/numerics.md, "Seeing water").
class WaterShading {
  public:
    WaterShading();

    /// hits and colours are the ground's; the water must have been cast for the same camera.
    void draw(const Terrain& terrain, const Pyramid& ground, const WaterSurface& water, const Camera& camera,
              const ViewSettings& settings, int width, int height, const gpu::Texture& hits,
              const gpu::Texture& colours, const gpu::Framebuffer& target);

  private:
    ShadeList list_;
    gpu::Program dry_;  // where there is no water: the ground as it is
    gpu::Program mirroring_;
    gpu::Program quick_;
};

}  // namespace talus

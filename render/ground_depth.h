#pragma once
#include "sim/gpu/program.h"
#include "sim/gpu/texture.h"

namespace talus::render {

/// Depth of the window's pixels from the hits of the picture that it shows, so that what is drawn over the
/// picture can be hidden by the ground in front of it.
class GroundDepth {
  public:
    /// hits: of a picture of so many pixels, which the window shows in `area` (rows from below). Writes the
    /// depth of the window's pixels in `box`.
    void draw(const gpu::Texture& hits, glm::ivec2 picture, const gpu::Region& area, const gpu::Region& box);

    /// What is drawn from here on is hidden where the ground is nearer to the eye than this.
    static void hide_behind(double distance_m);
    /// Nothing is hidden any more.
    static void hide_nothing();

  private:
    gpu::Program program_{{"render/fullscreen.vert", "render/ground_depth.frag"}};
};

}  // namespace talus::render

#pragma once
#include "render/methods/method.h"

namespace talus {

/// Where the rays of a picture may start: beams of 8 x 8 pixels walk first and stop before any of their rays
/// can meet ground (shaders/maths/beam.glsl). Skipping changes no bit of a hit.
class Beams {
  public:
    /// With a define for shaders/render/beam.frag.
    explicit Beams(const std::vector<std::string>& defines = {})
        : program_({"render/fullscreen.vert", "render/beam.frag"}, defines) {}
    /// flatness: as in shaders/maths/beam.glsl, for programs made with FLAT_ENDS.
    void cast(const Frame& frame, double flatness = 0);
    /// Binds them for shaders/render/exact.frag.
    void bind() const { beams_.bind_sampled(4); }

  private:
    gpu::Program program_;
    gpu::Texture beams_;
    gpu::Framebuffer buffer_;
};

}  // namespace talus

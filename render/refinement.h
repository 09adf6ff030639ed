#pragma once
#include "render/hits_target.h"
#include "sim/gpu/program.h"

namespace talus::render {

/// Where a picture at rest gathers more samples a pixel: each is the same picture shifted within its pixels,
/// so the mean is a function of the picture and the number of samples alone (law 2).
class Refinement {
  public:
    Refinement();

    /// Samples in the mean; 1 at most: there is none yet.
    int samples() const { return samples_; }
    void restart() { samples_ = 0; }
    /// The shift of a sample in pixels: a low-discrepancy sequence, the first is 0.
    static glm::dvec2 shift_px(int sample);

    /// What the next sample is drawn into.
    const HitsTarget& target(int width, int height);
    const gpu::Framebuffer& colour_buffer() const { return colour_buffer_; }
    const gpu::Texture& colour() const { return colour_; }
    /// Takes the next sample.
    void add(const gpu::Texture& picture, int width, int height);

    const gpu::Texture& mean() const { return mean_; }
    const gpu::Framebuffer& mean_buffer() const { return mean_buffer_; }

  private:
    int samples_ = 0;
    gpu::Program add_;
    HitsTarget target_;
    gpu::Texture colour_;
    gpu::Texture sum_;
    gpu::Texture mean_;
    gpu::Framebuffer colour_buffer_;
    gpu::Framebuffer mean_buffer_;
};

}  // namespace talus::render

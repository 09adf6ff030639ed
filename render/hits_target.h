#pragma once
#include <array>
#include <vector>

#include "sim/gpu/texture.h"

namespace talus::render {

/// What methods draw into: distance and detail of every pixel (methods/method.h), and depth for triangles.
class HitsTarget {
  public:
    HitsTarget() = default;
    HitsTarget(int width, int height);

    const gpu::Texture& hits() const { return hits_; }
    const gpu::Framebuffer& framebuffer() const { return framebuffer_; }
    std::size_t bytes() const;
    /// Rows bottom up. Waits for the device.
    std::vector<float> read_distances(int width, int height) const;
    std::vector<float> read_details(int width, int height) const;

  private:
    gpu::Texture hits_;
    gpu::Texture depth_;
    gpu::Framebuffer framebuffer_;
};

}  // namespace talus::render

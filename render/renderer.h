#pragma once
#include <memory>
#include <string>
#include <vector>

#include "render/camera.h"
#include "render/methods/method.h"
#include "render/pyramid.h"
#include "render/view.h"
#include "sim/gpu/readback.h"

namespace talus {

/// Draws a terrain into its own framebuffer: a method fills the hits, one shader colours them for every
/// method.
class Renderer {
  public:
    explicit Renderer(const Terrain& terrain);

    /// Brings the pyramid up to date with the terrain's changed tiles and draws width x height pixels.
    void draw(Terrain& terrain, const Camera& camera, const ViewSettings& settings, int width, int height);

    /// What draw() made: rows bottom up; textures may be larger than the picture.
    const gpu::Texture& colour() const { return colour_; }
    const gpu::Framebuffer& framebuffer() const { return colour_buffer_; }
    /// Distance in metres along each pixel's normalised ray (infinity: nothing hit) and steps.
    const gpu::Texture& hits() const { return hits_; }
    const Pyramid& pyramid() const { return pyramid_; }

    /// Top row first; waits for the device.
    std::vector<std::uint8_t> read_rgb(int width, int height) const;
    std::vector<float> read_depth(int width, int height) const;
    /// Lowest and highest sample of the terrain, a frame or two old: read without waiting. 0 before the
    /// second frame.
    glm::dvec2 bounds() const { return bounds_; }

  private:
    void resize(int width, int height);
    void follow_bounds();

    Pyramid pyramid_;
    std::vector<std::pair<std::string, Method>> methods_;
    gpu::Program shade_;
    gpu::Texture hits_;
    gpu::Texture depth_;
    gpu::Texture colour_;
    gpu::Framebuffer hits_buffer_;
    gpu::Framebuffer colour_buffer_;
    gpu::Readback lowest_readback_;
    gpu::Readback highest_readback_;
    glm::dvec2 bounds_{0};
};

}  // namespace talus

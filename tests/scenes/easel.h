#pragma once
#include <vector>

#include "render/hits_target.h"
#include "render/methods/method.h"
#include "render/pyramid.h"
#include "sim/terrain/terrain.h"
#include "tests/scenes/scenes.h"

namespace talus::scenes {

/// A terrain on the device, and what methods draw of it, read back.
class Easel {
  public:
    Easel(const Scene& scene, int width, int height)
        : terrain(bedrock_terrain(scene.grid, scene.heights)),
          pyramid(terrain),
          width_(width),
          height_(height),
          target_(width, height) {
        pyramid.refresh(terrain);
    }

    /// Distance and detail of every pixel, rows bottom up.
    std::vector<glm::vec2> draw(const render::Method& method, const render::Camera& camera,
                                double tolerance_px, const render::OwnNumbers& numbers = {}) {
        method({terrain, pyramid, camera, width_, height_, tolerance_px, patch_pixels, target_.framebuffer(),
                nullptr, numbers});
        return target_.hits().read_all<glm::vec2>();
    }

    Terrain terrain;
    render::Pyramid pyramid;
    double patch_pixels = 8;  ///< more mesh than any device would choose

  private:
    int width_;
    int height_;
    render::HitsTarget target_;
};

inline std::vector<float> distances(const std::vector<glm::vec2>& hits) {
    std::vector<float> result;
    result.reserve(hits.size());
    for (const glm::vec2 hit : hits) result.push_back(hit.x);
    return result;
}

}  // namespace talus::scenes

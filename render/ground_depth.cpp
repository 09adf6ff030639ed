#include "render/ground_depth.h"

#include <algorithm>
#include <cmath>

#include "sim/gpu/window.h"

namespace talus::render {
namespace {

// By logarithms 24 bits tell distances apart to 5e-6 of them, from 1e-19 m to 1e19 m.
constexpr double log2_scale = 128;

// While it lives, draws change the depth of this region of the window alone; where one throws, colours come
// back.
class DepthAlone {
  public:
    explicit DepthAlone(const gpu::Region& box) : box_(box) { gpu::bind_window_depth(box_); }
    ~DepthAlone() { gpu::bind_window(box_); }
    DepthAlone(const DepthAlone&) = delete;
    DepthAlone& operator=(const DepthAlone&) = delete;

  private:
    gpu::Region box_;
};

}  // namespace

void GroundDepth::draw(const gpu::Texture& hits, glm::ivec2 picture, const gpu::Region& area,
                       const gpu::Region& box) {
    program_.bind_sampled("hits", hits);
    program_.set("picture", picture);
    program_.set("area_from", glm::vec2(area.x, area.y));
    program_.set("area_size", glm::vec2(area.width, area.height));
    program_.set("log2_scale", static_cast<float>(log2_scale));
    const DepthAlone writes(box);
    program_.draw_fullscreen(gpu::Depth::reset);
}

void GroundDepth::hide_behind(double distance_m) {
    gpu::draw_at_depth(
        static_cast<float>(std::clamp(0.5 - std::log2(std::max(distance_m, 1e-20)) / log2_scale, 0.0, 1.0)));
}

void GroundDepth::hide_nothing() {
    gpu::draw_without_depth();
}

}  // namespace talus::render

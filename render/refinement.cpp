#include "render/refinement.h"

#include <algorithm>
#include <cmath>

namespace talus::render {

Refinement::Refinement() : add_("render/refine.comp") {}

glm::dvec2 Refinement::shift_px(int sample) {
    // Roberts 2018, "The unreasonable effectiveness of quasirandom sequences": R2.
    const double x = 0.7548776662466927 * sample;
    const double y = 0.5698402909980532 * sample;
    return {x - std::round(x), y - std::round(y)};
}

const HitsTarget& Refinement::target(int width, int height) {
    if (colour_.width() < width || colour_.height() < height) {
        const int w = std::max(width, colour_.width());
        const int h = std::max(height, colour_.height());
        target_ = HitsTarget(w, h);
        colour_ = gpu::Texture("colour of a sample", gpu::Format::rgba8, w, h);
        sum_ = gpu::Texture("sum of samples", gpu::Format::rgba32f, w, h);
        mean_ = gpu::Texture("mean of samples", gpu::Format::rgba8, w, h);
        const std::array<const gpu::Texture*, 1> colour = {&colour_};
        const std::array<const gpu::Texture*, 1> mean = {&mean_};
        colour_buffer_ = gpu::Framebuffer("colour of a sample", colour);
        mean_buffer_ = gpu::Framebuffer("mean of samples", mean);
    }
    return target_;
}

void Refinement::add(const gpu::Texture& picture, int width, int height) {
    ++samples_;
    add_.set("size", glm::ivec2(width, height));
    add_.set("samples", samples_);
    add_.bind_sampled("picture", picture);
    add_.bind_image("sum", sum_);
    add_.bind_image("mean", mean_);
    add_.dispatch((width + 31) / 32, (height + 7) / 8);
    gpu::barrier({gpu::Use::image, gpu::Use::sampler, gpu::Use::texture_transfer, gpu::Use::framebuffer});
}

}  // namespace talus::render

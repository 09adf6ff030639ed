#include "render/methods/beams.h"

namespace talus {
namespace {

constexpr int beam_pixels = 8;  // as in shaders/render/beam_pixels.glsl

}  // namespace

void Beams::cast(const Frame& frame, double flatness) {
    const int width = (frame.width + beam_pixels - 1) / beam_pixels;
    const int height = (frame.height + beam_pixels - 1) / beam_pixels;
    if (beams_.width() < width || beams_.height() < height) {
        beams_ = gpu::Texture("beams", gpu::Format::rg32f, std::max(width, beams_.width()),
                              std::max(height, beams_.height()));
        const std::array<const gpu::Texture*, 1> colours = {&beams_};
        buffer_ = gpu::Framebuffer("beams", colours);
    }
    frame.pyramid.bind(program_, frame.terrain);
    set_camera(program_, frame.terrain.grid(), frame.camera, frame.width, frame.height);
    frame.pyramid.lowest.bind_sampled(2);
    program_.set("flatness", static_cast<float>(flatness));
    buffer_.bind({0, 0, width, height});
    program_.draw_fullscreen();
}

}  // namespace talus

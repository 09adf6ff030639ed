#include "render/outline.h"

#include <algorithm>
#include <array>

namespace talus::render {

Outline::Outline() : program_(std::vector<std::string>{"render/fullscreen.vert", "render/outline.frag"}) {}

void Outline::draw(const gpu::Texture& colours, const gpu::Texture& hits, const Grid& grid,
                   const Camera& camera, glm::ivec2 size, const Rectangle& rectangle,
                   const Rectangle& ground) {
    if (colour_.width() < size.x || colour_.height() < size.y) {
        colour_ = gpu::Texture("colour with outline", gpu::Format::rgba8, std::max(size.x, colour_.width()),
                               std::max(size.y, colour_.height()));
        const std::array<const gpu::Texture*, 1> attached = {&colour_};
        buffer_ = gpu::Framebuffer("colour with outline", attached);
    }
    set_camera(program_, grid, camera, size.x, size.y);
    program_.bind_sampled("hits", hits);
    program_.bind_sampled("picture_colour", colours);
    // As wide at any resolution, but never thinner than a pixel.
    const double pixels = std::max(1.3 * size.y / 720, 0.6);
    program_.set("line_px", static_cast<float>(pixels));
    const glm::dvec2 eye(camera.eye);
    const auto over_eye = [&](const Rectangle& r) {
        return glm::vec4(glm::vec2(glm::dvec2(r.west_m, r.south_m) - eye),
                         glm::vec2(glm::dvec2(r.east_m, r.north_m) - eye));
    };
    program_.set("edges_m", over_eye(rectangle));
    program_.set("border_m", over_eye(ground));
    buffer_.bind({0, 0, size.x, size.y});
    program_.draw_fullscreen();
}

}  // namespace talus::render

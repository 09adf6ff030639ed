#include "render/renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "sim/gpu/error.h"

namespace talus {

Renderer::Renderer(const Terrain& terrain)
    : pyramid_(terrain), shade_(std::vector<std::string>{"render/fullscreen.vert", "render/shade.frag"}) {}

void Renderer::resize(int width, int height) {
    if (hits_.width() >= width && hits_.height() >= height) return;
    const int w = std::max(width, hits_.width());
    const int h = std::max(height, hits_.height());
    hits_ = gpu::Texture("hits", gpu::Format::rg32f, w, h);
    colour_ = gpu::Texture("colour", gpu::Format::rgba8, w, h);
    const std::array<const gpu::Texture*, 1> hits = {&hits_};
    const std::array<const gpu::Texture*, 1> colour = {&colour_};
    depth_ = gpu::Texture("depth", gpu::Format::depth32f, w, h);
    hits_buffer_ = gpu::Framebuffer("hits", hits, &depth_);
    colour_buffer_ = gpu::Framebuffer("colour", colour);
}

void Renderer::draw(Terrain& terrain, const Camera& camera, const ViewSettings& settings, int width,
                    int height) {
    resize(width, height);
    pyramid_.refresh(terrain);
    follow_bounds();
    const Detail detail = settings.view == View::steps   ? Detail::steps
                          : settings.view == View::cells ? Detail::kind
                                                         : Detail::none;
    const std::string key = settings.method + std::to_string(static_cast<int>(detail));
    auto found =
        std::find_if(methods_.begin(), methods_.end(), [&](const auto& m) { return m.first == key; });
    if (found == methods_.end()) {
        const auto entry = std::find_if(talus::methods().begin(), talus::methods().end(),
                                        [&](const MethodEntry& e) { return e.name == settings.method; });
        if (entry == talus::methods().end()) throw Error("there is no method '" + settings.method + "'");
        methods_.emplace_back(key, entry->make(detail));
        found = methods_.end() - 1;
    }
    found->second({terrain, pyramid_, camera, width, height, settings.tolerance_px, 60, hits_buffer_});

    const Grid& grid = terrain.grid();
    set_camera(shade_, grid, camera, width, height);
    pyramid_.bind(shade_, terrain);
    pyramid_.lowest.bind_sampled(2);
    terrain.solid.front.bind_sampled(3);
    hits_.bind_sampled(4);
    shade_.set("view", static_cast<int>(settings.view));
    shade_.set("sun", glm::vec3(settings.sun));
    shade_.set("shadows", settings.shadows ? 1 : 0);
    shade_.set("extent_m", static_cast<float>(std::max(grid.width_m(), grid.height_m())));
    shade_.set("pixel_angle", static_cast<float>(camera.fov_deg * std::numbers::pi / 180 / height));
    // The ring is as wide at any resolution, but never thinner than a pixel.
    const double ring_pixels = std::max(1.3 * height / 720, 0.6);
    shade_.set("ring_angle",
               static_cast<float>(ring_pixels * camera.fov_deg * std::numbers::pi / 180 / height));
    shade_.set("band_m", static_cast<float>(settings.band_m));
    shade_.set("slope_scale_deg", static_cast<float>(slope_scale_deg));
    shade_.set("steps_scale", static_cast<float>(steps_scale));
    shade_.set("ring_m", glm::vec3(settings.ring_m.x - camera.eye.x, settings.ring_m.y - camera.eye.y,
                                   settings.ring_m.z));
    colour_buffer_.bind({0, 0, width, height});
    shade_.draw_fullscreen();
}

std::vector<std::uint8_t> Renderer::read_rgb(int width, int height) const {
    std::vector<std::uint8_t> rgba(static_cast<std::size_t>(width) * height * 4);
    colour_.read({0, 0, width, height}, std::as_writable_bytes(std::span(rgba)));
    std::vector<std::uint8_t> rgb;
    rgb.reserve(static_cast<std::size_t>(width) * height * 3);
    for (int y = height - 1; y >= 0; --y)
        for (int x = 0; x < width; ++x) {
            const std::size_t at = (static_cast<std::size_t>(y) * width + x) * 4;
            rgb.insert(rgb.end(), {rgba[at], rgba[at + 1], rgba[at + 2]});
        }
    return rgb;
}

std::vector<float> Renderer::read_depth(int width, int height) const {
    std::vector<glm::vec2> texels(static_cast<std::size_t>(width) * height);
    hits_.read({0, 0, width, height}, std::as_writable_bytes(std::span(texels)));
    std::vector<float> values;
    values.reserve(texels.size());
    for (int y = height - 1; y >= 0; --y)
        for (int x = 0; x < width; ++x) values.push_back(texels[static_cast<std::size_t>(y) * width + x].x);
    return values;
}

void Renderer::follow_bounds() {
    const gpu::Region last{pyramid_.highest.width() - 1, pyramid_.highest.height() - 1, 1, 1};
    if (const auto texel = lowest_readback_.poll()) bounds_.x = (*texel)[0];
    if (const auto texel = highest_readback_.poll()) bounds_.y = (*texel)[0];
    if (!lowest_readback_.pending()) lowest_readback_.start(pyramid_.lowest, last);
    if (!highest_readback_.pending()) highest_readback_.start(pyramid_.highest, last);
}

}  // namespace talus

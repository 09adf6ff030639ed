#include "render/renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "sim/gpu/error.h"

namespace talus {

namespace {

Detail detail_of(View view) {
    return view == View::steps ? Detail::steps : view == View::cells ? Detail::kind : Detail::none;
}

// Whether the hits of two pictures of the same terrain are the same.
bool same_hits(const ViewSettings& a, const ViewSettings& b) {
    return a.method == b.method && a.tolerance_px == b.tolerance_px && detail_of(a.view) == detail_of(b.view);
}

}  // namespace

Renderer::Renderer(const Terrain& terrain, double patch_pixels)
    : pyramid_(terrain),
      shade_({"render/fullscreen.vert", "render/shade.frag"}),
      shade_blocks_({"render/block.vert", "render/shade.frag"}),
      ring_({"render/fullscreen.vert", "render/ring.frag"}),
      patch_pixels_(patch_pixels) {}

void Renderer::resize(int width, int height) {
    if (colour_.width() >= width && colour_.height() >= height) return;
    const int w = std::max(width, colour_.width());
    const int h = std::max(height, colour_.height());
    target_ = HitsTarget(w, h);
    colour_ = gpu::Texture("colour", gpu::Format::rgba8, w, h);
    ringed_colour_ = gpu::Texture("colour with ring", gpu::Format::rgba8, w, h);
    const std::array<const gpu::Texture*, 1> colour = {&colour_};
    const std::array<const gpu::Texture*, 1> ringed = {&ringed_colour_};
    colour_buffer_ = gpu::Framebuffer("colour", colour);
    ringed_buffer_ = gpu::Framebuffer("colour with ring", ringed);
    drawn_.reset();
}

const Method& Renderer::method_of(const ViewSettings& settings, bool& redraws_blocks) {
    const auto entry = std::find_if(talus::methods().begin(), talus::methods().end(),
                                    [&](const MethodEntry& e) { return e.name == settings.method; });
    if (entry == talus::methods().end()) throw Error("there is no method '" + settings.method + "'");
    const Detail detail = detail_of(settings.view);
    // Steps of a walk depend on bounds far from where it ends.
    redraws_blocks = entry->redraws_blocks && detail != Detail::steps;
    const std::string key = settings.method + std::to_string(static_cast<int>(detail));
    auto found =
        std::find_if(methods_.begin(), methods_.end(), [&](const auto& m) { return m.first == key; });
    if (found == methods_.end()) found = methods_.insert(methods_.end(), {key, entry->make(detail)});
    return found->second;
}

Drawn Renderer::draw(Terrain& terrain, const Camera& camera, const ViewSettings& settings, int width,
                     int height) {
    resize(width, height);
    Picture picture{camera, settings, width, height, terrain.tiles.changes()};
    picture.settings.ring_m = glm::dvec3(0);
    // What throws half way leaves nothing to build on.
    const std::optional<Picture> before = std::exchange(drawn_, std::nullopt);
    const Drawn drawn = redraw(terrain, picture, before);
    drawn_ = picture;
    follow_bounds(drawn != Drawn::nothing);
    ringed_ = settings.ring_m.z > 0;
    if (ringed_) draw_ring(terrain.grid(), picture, settings.ring_m);
    return drawn;
}

Drawn Renderer::redraw(Terrain& terrain, const Picture& picture, const std::optional<Picture>& before) {
    if (before == picture) return Drawn::nothing;
    const bool same_view = before && before->camera == picture.camera && before->width == picture.width &&
                           before->height == picture.height && same_hits(before->settings, picture.settings);
    const bool same_terrain = before && before->changes == picture.changes;
    if (same_view && same_terrain) {
        shade(terrain, picture, false);
        return Drawn::colours;
    }
    bool redraws_blocks = false;
    const Method& method = method_of(picture.settings, redraws_blocks);
    const bool blocks = redraws_blocks && same_view && before->settings == picture.settings;
    const bool shadows = picture.settings.shadows && picture.settings.view == View::shaded;
    const glm::dvec3 sun = shadows ? picture.settings.sun : glm::dvec3(0);
    if (blocks) redraw_.begin(picture.width, picture.height);
    if (refreshed_changes_ != picture.changes) {
        const TileList& changed = pyramid_.list_changes(terrain);
        if (blocks) redraw_.mark(false, changed, terrain, pyramid_, picture.camera, sun);
        pyramid_.rebuild(terrain);
        if (blocks) redraw_.mark(true, changed, terrain, pyramid_, picture.camera, sun);
        refreshed_changes_ = picture.changes;
    }
    method({terrain, pyramid_, picture.camera, picture.width, picture.height, picture.settings.tolerance_px,
            patch_pixels_, target_.framebuffer(), blocks ? &redraw_ : nullptr});
    shade(terrain, picture, blocks);
    return blocks ? Drawn::changes : Drawn::everything;
}

void Renderer::shade(const Terrain& terrain, const Picture& picture, bool blocks) {
    const ViewSettings& settings = picture.settings;
    const Grid& grid = terrain.grid();
    gpu::Program& program = blocks ? shade_blocks_ : shade_;
    set_camera(program, grid, picture.camera, picture.width, picture.height);
    pyramid_.bind(program, terrain);
    pyramid_.lowest.bind_sampled(2);
    terrain.solid.front.bind_sampled(3);
    target_.hits().bind_sampled(4);
    program.set("view", static_cast<int>(settings.view));
    program.set("sun", glm::vec3(settings.sun));
    program.set("shadows", settings.shadows ? 1 : 0);
    program.set("extent_m", static_cast<float>(std::max(grid.width_m(), grid.height_m())));
    program.set("pixel_angle",
                static_cast<float>(picture.camera.fov_deg * std::numbers::pi / 180 / picture.height));
    program.set("band_m", static_cast<float>(settings.band_m));
    terrain.start.bind_sampled(5);
    program.set("difference_m", static_cast<float>(settings.difference_m));
    program.set("hillshade_lights", settings.hillshade_lights);
    program.set("slope_scale_deg", static_cast<float>(slope_scale_deg));
    program.set("steps_scale", static_cast<float>(steps_scale));
    if (blocks) {
        redraw_.draw(program, colour_buffer_, gpu::Depth::none);
    } else {
        colour_buffer_.bind({0, 0, picture.width, picture.height});
        program.draw_fullscreen();
    }
}

void Renderer::draw_ring(const Grid& grid, const Picture& picture, glm::dvec3 ring_m) {
    set_camera(ring_, grid, picture.camera, picture.width, picture.height);
    target_.hits().bind_sampled(4);
    colour_.bind_sampled(5);
    // As wide at any resolution, but never thinner than a pixel.
    const double pixels = std::max(1.3 * picture.height / 720, 0.6);
    ring_.set("ring_angle",
              static_cast<float>(pixels * picture.camera.fov_deg * std::numbers::pi / 180 / picture.height));
    ring_.set("ring_m",
              glm::vec3(ring_m.x - picture.camera.eye.x, ring_m.y - picture.camera.eye.y, ring_m.z));
    ringed_buffer_.bind({0, 0, picture.width, picture.height});
    ring_.draw_fullscreen();
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
    const std::vector<float> bottom_up = target_.read_distances(width, height);
    std::vector<float> values;
    values.reserve(bottom_up.size());
    for (int y = height - 1; y >= 0; --y) {
        const auto row = bottom_up.begin() + static_cast<std::ptrdiff_t>(y) * width;
        values.insert(values.end(), row, row + width);
    }
    return values;
}

void Renderer::follow_bounds(bool again) {
    const gpu::Region last{pyramid_.highest.width() - 1, pyramid_.highest.height() - 1, 1, 1};
    if (const auto texel = lowest_readback_.poll()) bounds_.x = (*texel)[0];
    if (const auto texel = highest_readback_.poll()) bounds_.y = (*texel)[0];
    bounds_stale_ = bounds_stale_ || again;
    if (!bounds_stale_ || lowest_readback_.pending() || highest_readback_.pending()) return;
    lowest_readback_.start(pyramid_.lowest, last);
    highest_readback_.start(pyramid_.highest, last);
    bounds_stale_ = false;
}

}  // namespace talus

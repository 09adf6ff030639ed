#include "render/renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "render/methods/parallel.h"
#include "render/picture_readback.h"
#include "sim/error.h"

namespace talus::render {

namespace {

// How many samples around a place its colours look at: filtered normals, and what stands before the sky.
constexpr int normals_reach = 14;
constexpr int sky_reach = 64;

Detail detail_of(const ViewSettings& settings) {
    return view_named(settings.view).detail;
}

bool is_natural(const ViewSettings& settings) {
    return view_named(settings.view).natural;
}

// Whether the hits of two pictures of the same terrain are the same.
bool same_hits(const ViewSettings& a, const ViewSettings& b) {
    if (a.method != b.method || a.tolerance_px != b.tolerance_px || detail_of(a) != detail_of(b))
        return false;
    const std::vector<Parameter>& own = method_named(a.method).parameters;
    return std::all_of(own.begin(), own.end(), [&](const Parameter& parameter) {
        return own_number(a.numbers, parameter) == own_number(b.numbers, parameter);
    });
}

}  // namespace

Renderer::Renderer(const Terrain& terrain, double patch_pixels)
    : pyramid_(terrain),
      sky_view_(terrain),
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
    ground_colour_ = gpu::Texture();
    colour_buffer_ = gpu::Framebuffer("colour", colour);
    ringed_buffer_ = gpu::Framebuffer("colour with ring", ringed);
    drawn_.reset();
}

const Method& Renderer::method_of(const Picture& picture, const char* use, bool& redraws_blocks) {
    static const MethodEntry parallel{"parallel", "", make_parallel, true};
    const MethodEntry& entry =
        picture.camera.is_parallel() ? parallel : method_named(picture.settings.method);
    const Detail detail = detail_of(picture.settings);
    // Steps of a walk depend on bounds far from where it ends.
    redraws_blocks = entry.redraws_blocks && detail != Detail::steps;
    // A method may hold images of the terrain's size: those that are not chosen any more are let go.
    std::erase_if(methods_, [&](const MadeMethod& made) { return made.name != entry.name; });
    auto found = std::find_if(methods_.begin(), methods_.end(), [&](const MadeMethod& made) {
        return made.use == use && made.detail == detail;
    });
    if (found == methods_.end())
        found = methods_.insert(methods_.end(), {entry.name, use, detail, entry.make(detail)});
    return found->method;
}

Drawn Renderer::draw(const Terrain& terrain, const Camera& camera, const ViewSettings& settings, int width,
                     int height, const Ring& ring) {
    resize(width, height);
    const Picture picture{
        camera,        settings, width, height, terrain.tiles.now(), backdrop_ ? backdrop_->changes() : 0,
        photo_.changes};
    // If drawing throws half way, the next draw starts from scratch.
    const std::optional<Picture> before = std::exchange(drawn_, std::nullopt);
    const Drawn drawn = redraw(terrain, picture, before);
    drawn_ = picture;
    follow_bounds(drawn != Drawn::nothing);
    ringed_ = ring.radius_m > 0;
    ring_on_ = ring;
    if (drawn != Drawn::nothing) refinement_.restart();
    if (ringed_) draw_ring(terrain.grid());
    return drawn;
}

bool Renderer::refine(const Terrain& terrain, int samples) {
    if (!drawn_) return false;
    // Fewer than there are: the mean is made anew.
    const bool fewer = refinement_.samples() > std::max(samples, 1);
    if (fewer) refinement_.restart();
    if (fewer && ringed_) draw_ring(terrain.grid());
    if (refinement_.samples() >= samples || samples < 2) return fewer;
    Picture picture = *drawn_;
    const HitsTarget& target = refinement_.target(picture.width, picture.height);
    if (refinement_.samples() == 0) refinement_.add(colour_, picture.width, picture.height);
    const glm::dvec2 shift_px = Refinement::shift_px(refinement_.samples());
    picture.camera.window_middle +=
        2.0 * shift_px * picture.camera.window_share / glm::dvec2(picture.width, picture.height);
    // A method of its own: what it keeps for the next change belongs to the picture that was not shifted.
    bool redraws_blocks = false;
    method_of(picture, " refined ", redraws_blocks)(
        {terrain, pyramid_, picture.camera, picture.width, picture.height, picture.settings.tolerance_px,
         patch_pixels_, target.framebuffer(), nullptr, picture.settings.numbers});
    colour(terrain, picture, target.hits(), refinement_.colour_buffer(), nullptr, false);
    refinement_.add(refinement_.colour(), picture.width, picture.height);
    if (ringed_) draw_ring(terrain.grid());
    return true;
}

void Renderer::drape(int width, int height, std::span<const std::byte> rgba) {
    shading_.drape(width, height, rgba);
    forget();
}

Drawn Renderer::redraw(const Terrain& terrain, const Picture& picture, const std::optional<Picture>& before) {
    if (before == picture) return Drawn::nothing;
    const bool same_view = before && before->camera == picture.camera && before->width == picture.width &&
                           before->height == picture.height && same_hits(before->settings, picture.settings);
    const bool same_terrain = before && before->changes == picture.changes;
    if (same_view && same_terrain) {
        follow_sky(terrain, picture.settings);
        shade(terrain, picture, nullptr);
        return Drawn::colours;
    }
    bool redraws_blocks = false;
    const Method& method = method_of(picture, " drawn ", redraws_blocks);
    // What water shows of the ground may lie anywhere in the picture.
    const bool blocks = redraws_blocks && same_view && before->settings == picture.settings &&
                        before->around == picture.around && before->photo == picture.photo && !terrain.water;
    const bool natural = is_natural(picture.settings);
    const bool shadows = picture.settings.shadows && !picture.settings.quick && natural;
    const glm::dvec3 sun = shadows ? picture.settings.sun : glm::dvec3(0);
    const bool looks_far = picture.settings.occlusion && natural;
    const int reach = looks_far ? sky_reach : normals_reach;
    if (blocks) redraw_.begin(picture.width, picture.height);
    if (refreshed_changes_ != picture.changes) {
        const TileList& changed = pyramid_.list_changes(terrain);
        if (blocks) redraw_.mark(false, changed, terrain, pyramid_, picture.camera, sun, reach);
        pyramid_.rebuild(terrain);
        if (blocks) redraw_.mark(true, changed, terrain, pyramid_, picture.camera, sun, reach);
        if (terrain.water) {
            if (!water_) water_ = std::make_unique<WaterSurface>(terrain);
            water_->refresh(terrain);
        }
        refreshed_changes_ = picture.changes;
    }
    follow_sky(terrain, picture.settings);
    method({terrain, pyramid_, picture.camera, picture.width, picture.height, picture.settings.tolerance_px,
            patch_pixels_, target_.framebuffer(), blocks ? &redraw_ : nullptr, picture.settings.numbers});
    shade(terrain, picture, blocks ? &redraw_ : nullptr);
    return blocks ? Drawn::changes : Drawn::everything;
}

void Renderer::follow_sky(const Terrain& terrain, const ViewSettings& settings) {
    // What no view looks at waits until one does.
    if (!settings.occlusion || !is_natural(settings) || sky_changes_ == refreshed_changes_) return;
    sky_view_.refresh(terrain, pyramid_);
    sky_changes_ = refreshed_changes_;
}

void Renderer::shade(const Terrain& terrain, const Picture& picture, const Redraw* redraw) {
    colour(terrain, picture, target_.hits(), colour_buffer_, redraw, true);
}

void Renderer::colour(const Terrain& terrain, const Picture& picture, const gpu::Texture& hits,
                      const gpu::Framebuffer& target, const Redraw* redraw, bool is_kept) {
    const bool watered = water_ && is_natural(picture.settings);
    if (watered && ground_colour_.width() == 0) {
        ground_colour_ =
            gpu::Texture("colour of the ground", gpu::Format::rgba8, colour_.width(), colour_.height());
        const std::array<const gpu::Texture*, 1> attached = {&ground_colour_};
        ground_colour_buffer_ = gpu::Framebuffer("colour of the ground", attached);
    }
    const ShadeFrame frame{picture.camera, picture.settings,
                           picture.width,  picture.height,
                           hits,           watered ? ground_colour_buffer_ : target};
    ShadedGround ground = shaded_ground(terrain, pyramid_, sky_view_, picture.settings.view);
    ground.photo = photo_;
    if (backdrop_) ground.beside = backdrop_->beside(frame, redraw);
    shading_.draw(frame, ground, redraw);
    const ShadeFrame over{picture.camera, picture.settings, picture.width, picture.height, hits, target};
    if (watered) {
        water_->cast(terrain, picture.camera, picture.width, picture.height);
        water_shading_.draw(over, terrain, pyramid_, *water_, ground_colour_, extent_m(ground));
    }
    if (backdrop_)
        backdrop_->draw(
            {over, watered ? &water_->target().hits() : nullptr, ground, picture.changes, is_kept});
}

// What the ring can cover: the box around it, from the lowest to the highest ground. All of the picture where
// a part of that lies beside or behind the eye.
gpu::Region Renderer::ring_region(const Picture& picture) const {
    const CameraRays rays = camera_rays(picture.camera, picture.width, picture.height);
    glm::dvec2 low(1e9);
    glm::dvec2 high(-1e9);
    // As wide as its line besides.
    const double reach = 1.1 * ring_on_.radius_m;
    const glm::dvec2 heights(bounds_.x - reach, bounds_.y + reach);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 point(ring_on_.at_m.x + ((corner & 1) != 0 ? reach : -reach),
                               ring_on_.at_m.y + ((corner & 2) != 0 ? reach : -reach), heights[corner >> 2]);
        const std::optional<glm::dvec2> at = place_in_picture(picture.camera, rays, point);
        if (!at) return {0, 0, picture.width, picture.height};
        low = glm::min(low, *at);
        high = glm::max(high, *at);
    }
    const glm::dvec2 size(picture.width, picture.height);
    const glm::ivec2 first = glm::clamp((0.5 + 0.5 * low) * size - 8.0, glm::dvec2(0), size);
    const glm::ivec2 last = glm::clamp((0.5 + 0.5 * high) * size + 8.0, glm::dvec2(0), size);
    return {first.x, first.y, last.x - first.x, last.y - first.y};
}

void Renderer::draw_ring(const Grid& grid) {
    const Picture& picture = *drawn_;
    if (ring_on_.stamp && !stamp_ring_)
        stamp_ring_.emplace(std::vector<std::string>{"render/fullscreen.vert", "render/ring.frag"},
                            std::vector<std::string>{"STAMP 1"});
    gpu::Program& ring = ring_on_.stamp ? *stamp_ring_ : ring_;
    set_camera(ring, grid, picture.camera, picture.width, picture.height);
    ring.bind_sampled("hits", hits());
    ring.bind_sampled("picture_colour", refined() ? refinement_.mean() : colour_);
    // As wide at any resolution, but never thinner than a pixel.
    const double pixels = std::max(1.3 * picture.height / 720, 0.6);
    ring.set("line_px", static_cast<float>(pixels));
    ring.set("ring_m",
             glm::vec3(glm::dvec2(ring_on_.at_m) - glm::dvec2(picture.camera.eye), ring_on_.radius_m));
    const double margin = 0.01 * std::min(grid.dx, grid.dy);
    const glm::dvec2 eye(picture.camera.eye);
    ring.set("border_m", glm::vec4(glm::vec2(margin - eye),
                                   glm::vec2(glm::dvec2(grid.width_m(), grid.height_m()) - margin - eye)));
    if (ring_on_.stamp) {
        ring.bind_sampled("stamp", *ring_on_.stamp);
        ring.set("stamp_columns", glm::vec2(ring_on_.stamp_columns));
        ring.set("stamp_rows", glm::vec2(ring_on_.stamp_rows));
    }
    const gpu::Region all{0, 0, picture.width, picture.height};
    ringed_colour_.copy_from(refined() ? refinement_.mean() : colour_, all);
    ringed_buffer_.bind(all, ring_region(picture));
    ring.draw_fullscreen();
    ringed_buffer_.bind(all);
}

std::vector<std::uint8_t> Renderer::read_rgb(int width, int height) const {
    return read_picture_rgb(colours(), width, height);
}

std::vector<float> Renderer::read_depth(int width, int height) const {
    return read_picture_depth(backdrop_ ? backdrop_->nearest() : target_, width, height);
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

}  // namespace talus::render

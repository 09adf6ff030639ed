#include "render/tiled/tiled_renderer.h"

#include <fmt/format.h>

#include <algorithm>

#include "render/picture_readback.h"
#include "sim/error.h"

namespace talus::render {
bool is_of_tiles(const View& view) {
    return view.layers.empty() && !view.whole;
}

void check_view_of_tiles(const ViewSettings& settings) {
    if (!is_of_tiles(view_named(settings.view)))
        throw Error(fmt::format("the view '{}' needs a terrain that is held as a whole, not one in tiles",
                                settings.view));
}

bool is_heeded_in_tiles(const std::string& parameter, const Parameters& drawing, bool draped) {
    if (parameter == "render.tolerance_px") return true;
    if (parameter == "render.method" || parameter == "render.occlusion" || parameter == "material.masked")
        return false;
    for (const MethodEntry& method : methods())
        for (const Parameter& own : method.parameters)
            if (own.name == parameter) return false;
    return is_heeded(parameter, drawing, draped);
}

std::vector<Legend> tiled_legend_of(const ViewSettings& settings, const TiledSurface& surface) {
    if (view_named(settings.view).detail == Detail::kind)
        return {{"Level of the tile", 0, static_cast<double>(std::max(surface.tree().top_level(), 1)),
                 "0: the finest", Legend::Scale::map}};
    return legend_of(settings, surface.lowest_m(), surface.highest_m());
}

void TiledRenderer::draw(const TiledSurface& surface, const Camera& camera, const ViewSettings& settings,
                         int width, int height) {
    check_view_of_tiles(settings);
    resize(width, height);
    drawn_ = {camera, settings, width, height};
    refinement_.restart();
    cast(surface, drawn_, target_.framebuffer());
    colour(surface, drawn_, target_.hits(), colour_buffer_);
}

bool TiledRenderer::refine(const TiledSurface& surface, int samples) {
    if (refinement_.samples() >= samples || samples < 2) return false;
    Picture picture = drawn_;
    const HitsTarget& target = refinement_.target(picture.width, picture.height);
    if (refinement_.samples() == 0) refinement_.add(colour_, picture.width, picture.height);
    picture.camera.window_middle += 2.0 * Refinement::shift_px(refinement_.samples()) *
                                    picture.camera.window_share / glm::dvec2(picture.width, picture.height);
    cast(surface, picture, target.framebuffer());
    colour(surface, picture, target.hits(), refinement_.colour_buffer());
    refinement_.add(refinement_.colour(), picture.width, picture.height);
    return true;
}

void TiledRenderer::drape(int width, int height, std::span<const std::byte> rgba) {
    shading_.drape(width, height, rgba);
}

void TiledRenderer::resize(int width, int height) {
    if (colour_.width() >= width && colour_.height() >= height) return;
    const int w = std::max(width, colour_.width());
    const int h = std::max(height, colour_.height());
    target_ = HitsTarget(w, h);
    colour_ = gpu::Texture("colour", gpu::Format::rgba8, w, h);
    const std::array<const gpu::Texture*, 1> colour = {&colour_};
    colour_buffer_ = gpu::Framebuffer("colour", colour);
}

void TiledRenderer::cast(const TiledSurface& surface, const Picture& picture, const gpu::Framebuffer& hits) {
    const Detail detail = view_named(picture.settings.view).detail;
    TiledRays& rays = rays_.try_emplace(detail, detail).first->second;
    rays.cast(surface, picture.camera, {picture.width, picture.height}, hits);
}

void TiledRenderer::colour(const TiledSurface& surface, const Picture& picture, const gpu::Texture& hits,
                           const gpu::Framebuffer& target) {
    const glm::ivec2 size(picture.width, picture.height);
    ShadedGround ground{surface.tree().grid(), true, true, false,
                        [&](gpu::Program& program) { surface.bind(program, picture.camera, size); }};
    ground.photo = photo_;
    shading_.draw({picture.camera, picture.settings, picture.width, picture.height, hits, target}, ground,
                  nullptr);
}

std::vector<std::uint8_t> TiledRenderer::read_rgb(int width, int height) const {
    return read_picture_rgb(is_refined() ? refinement_.mean() : colour_, width, height);
}

std::vector<float> TiledRenderer::read_depth(int width, int height) const {
    return read_picture_depth(target_, width, height);
}

}  // namespace talus::render

#include "render/shading.h"

#include <algorithm>
#include <numbers>

#include "render/grain.h"

namespace talus {

Shading::Shading() : grain_(grain_texture()) {}

void Shading::drape(int width, int height, std::span<const std::byte> rgba) {
    drape_ = gpu::Texture();
    if (rgba.empty()) return;
    int levels = 1;
    while (std::max(width, height) >> levels > 0) ++levels;
    drape_ = gpu::Texture("drape", gpu::Format::srgb8, width, height, levels);
    drape_.write(drape_.whole(), rgba);
    drape_.filter(gpu::Wrap::edge);
}

gpu::Program& Shading::program_of(const ViewSettings& settings, bool blocks) {
    std::vector<std::string> defines = {"VIEW " + std::to_string(static_cast<int>(settings.view))};
    if (settings.view == View::shaded) {
        if (!gpu::filters_along()) defines.emplace_back("FILTERS_ROUND");
        if (settings.shadows) defines.emplace_back("SHADOWS");
        if (settings.occlusion) defines.emplace_back("OCCLUSION");
        if (drape_.width() > 0) defines.emplace_back("DRAPED");
    }
    std::string key = blocks ? "blocks" : "picture";
    for (const std::string& define : defines) key += " " + define;
    const auto found = programs_.find(key);
    if (found != programs_.end()) return found->second;
    const char* vertex = blocks ? "render/block.vert" : "render/fullscreen.vert";
    return programs_
        .emplace(key, gpu::Program(std::vector<std::string>{vertex, "render/shade.frag"}, defines))
        .first->second;
}

void Shading::draw(const Terrain& terrain, const Pyramid& pyramid, const SkyView& sky, const Camera& camera,
                   const ViewSettings& settings, int width, int height, const gpu::Texture& hits,
                   const gpu::Framebuffer& target, const Redraw* redraw) {
    const Grid& grid = terrain.grid();
    gpu::Program& program = program_of(settings, redraw != nullptr);
    set_camera(program, grid, camera, width, height);
    pyramid.bind(program, terrain);
    pyramid.lowest.bind_sampled(2);
    terrain.solid.front.bind_sampled(3);
    hits.bind_sampled(4);
    terrain.start.bind_sampled(5);
    grain_.bind_sampled(6);
    if (drape_.width() > 0) drape_.bind_sampled(7);
    sky.share().bind_sampled(8);
    program.set("sun", glm::vec3(settings.sun));
    program.set("extent_m", static_cast<float>(std::max(grid.width_m(), grid.height_m())));
    program.set("pixel_angle", static_cast<float>(pixel_at_one_metre(camera, height)));
    program.set("band_m", static_cast<float>(settings.band_m));
    program.set("difference_m", static_cast<float>(settings.difference_m));
    program.set("hillshade_lights", settings.hillshade_lights);
    program.set("slope_scale_deg", static_cast<float>(slope_scale_deg));
    program.set("steps_scale", static_cast<float>(steps_scale));
    if (redraw) {
        redraw->draw(program, target, gpu::Depth::none);
    } else {
        target.bind({0, 0, width, height});
        program.draw_fullscreen();
    }
}

}  // namespace talus

#include "render/shading.h"

#include <algorithm>

#include "render/blocks.h"
#include "render/grain.h"

namespace talus {

namespace {

// Views of the water, of what was painted, of its load: each reads a layer that may not be there.
const char* layer_define(View view) {
    if (view >= View::suspended) return "LOADED";
    return view >= View::hardness ? "PAINTED" : "WATER";
}

bool is_there(const Terrain& terrain, View view) {
    if (view < View::depth || view == View::regolith) return false;
    if (view == View::suspended) return terrain.suspended.has_value();
    return view >= View::hardness ? terrain.painted.has_value() : terrain.water.has_value();
}

}  // namespace

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

gpu::Program& Shading::program_of(const ViewSettings& settings, bool sky, bool there) {
    std::vector<std::string> defines = {"VIEW " + std::to_string(static_cast<int>(settings.view))};
    if (sky) {
        defines.emplace_back("SKY");
    } else if (settings.view == View::shaded) {
        if (!gpu::filters_along()) defines.emplace_back("FILTERS_ROUND");
        if (settings.shadows && !settings.quick) defines.emplace_back("SHADOWS");
        if (settings.occlusion) defines.emplace_back("OCCLUSION");
        if (drape_.width() > 0) defines.emplace_back("DRAPED");
    } else if (there) {
        defines.emplace_back(layer_define(settings.view));
    }
    std::string key;
    for (const std::string& define : defines) key += define + " ";
    const auto found = programs_.find(key);
    if (found != programs_.end()) return found->second;
    return programs_
        .emplace(key,
                 gpu::Program(std::vector<std::string>{"render/block.vert", "render/shade.frag"}, defines))
        .first->second;
}

void Shading::draw(const Terrain& terrain, const Pyramid& pyramid, const SkyView& sky, const Camera& camera,
                   const ViewSettings& settings, int width, int height, const gpu::Texture& hits,
                   const gpu::Framebuffer& target, const Redraw* redraw) {
    const Grid& grid = terrain.grid();
    const auto prepare = [&](gpu::Program& program) {
        set_camera(program, grid, camera, width, height);
        pyramid.bind(program, terrain);
        program.set("sun", glm::vec3(settings.sun));
        program.set("extent_m", static_cast<float>(std::max(grid.width_m(), grid.height_m())));
        program.set("pixel_angle", static_cast<float>(pixel_at_one_metre(camera, height)));
        program.set("band_m", static_cast<float>(settings.band_m));
        program.set("difference_m", static_cast<float>(settings.difference_m));
        program.set("depth_scale_m", static_cast<float>(settings.depth_m));
        program.set("speed_scale", static_cast<float>(settings.speed_m_per_s));
        program.set("level_middle_m", static_cast<float>(settings.level_m));
        program.set("level_scale_m", static_cast<float>(settings.level_range_m));
        program.set("arrival_scale_s", static_cast<float>(settings.arrival_s));
        program.set("suspended_scale_mm", static_cast<float>(settings.suspended_mm));
        program.set("regolith_scale_m", static_cast<float>(settings.regolith_m));
        program.set("rain_scale", static_cast<float>(settings.rain_mm_per_h));
        program.set("froude_scale", static_cast<float>(froude_scale));
        program.set("hillshade_lights", settings.hillshade_lights);
        program.set("slope_scale_deg", static_cast<float>(slope_scale_deg));
        program.set("steps_scale", static_cast<float>(steps_scale));
    };
    // Steps are counted for the sky too.
    const bool skips_sky = !redraw && settings.view != View::steps;
    if (!redraw) list_.make(hits, width, height);
    pyramid.lowest.bind_sampled(2);
    terrain.solid.front.bind_sampled(3);
    hits.bind_sampled(4);
    terrain.start.bind_sampled(5);
    grain_.bind_sampled(6);
    if (drape_.width() > 0) drape_.bind_sampled(7);
    sky.share().bind_sampled(8);
    if (terrain.water) terrain.water->front.bind_sampled(9);
    if (terrain.inundation) terrain.inundation->bind_sampled(10);
    if (terrain.painted) terrain.painted->bind_sampled(11);
    if (terrain.suspended) terrain.suspended->front.bind_sampled(12);
    gpu::Program& ground = program_of(settings, false, is_there(terrain, settings.view));
    prepare(ground);
    if (redraw) {
        redraw->draw(ground, target, gpu::Depth::none);
        return;
    }
    gpu::Program& nothing = skips_sky ? program_of(settings, true, false) : ground;
    if (skips_sky) prepare(nothing);
    draw_blocks(nothing, target, {width, height}, list_.nothing(), gpu::Depth::none);
    draw_blocks(ground, target, {width, height}, list_.something(), gpu::Depth::none);
}

}  // namespace talus

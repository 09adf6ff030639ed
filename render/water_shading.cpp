#include "render/water_shading.h"

#include <algorithm>

namespace talus::render {
namespace {

gpu::Program water_program(std::vector<std::string> defines) {
    return gpu::Program({"render/block.vert", "render/water.frag"}, std::move(defines));
}

}  // namespace

WaterShading::WaterShading()
    : dry_(water_program({"DRY 1"})),
      mirroring_(water_program({"MIRRORS_GROUND 1"})),
      quick_(water_program({})) {}

void WaterShading::draw(const ShadeFrame& frame, const Terrain& terrain, const Pyramid& pyramid,
                        const WaterSurface& water, const gpu::Texture& colours, double extent_m) {
    const Grid& grid = terrain.grid();
    list_.make(water.target().hits(), frame.width, frame.height);
    const auto bind = [&](gpu::Program& program) {
        pyramid.bind(program, terrain);
        program.bind_sampled("level", water.level());
        program.bind_sampled("hits", frame.hits);
        program.bind_sampled("water_hits", water.target().hits());
        program.bind_sampled("colours", colours);
        program.bind_sampled("water", terrain.water->front);
    };
    gpu::Program& program = frame.settings.quick ? quick_ : mirroring_;
    set_camera(program, grid, frame.camera, frame.width, frame.height);
    program.set("sun", glm::vec3(frame.settings.sun));
    program.set("extent_m", static_cast<float>(extent_m));
    program.set("gravity", static_cast<float>(frame.settings.gravity_m_per_s2));
    // Water has the colours of the shaded view.
    for (const ViewNumber& number : view_named(frame.settings.view).numbers)
        program.set(number.uniform.c_str(), static_cast<float>(number.in(frame.settings)));
    const glm::ivec2 size(frame.width, frame.height);
    bind(dry_);
    draw_blocks(dry_, frame.target, size, list_.nothing(), gpu::Depth::none);
    bind(program);
    draw_blocks(program, frame.target, size, list_.something(), gpu::Depth::none);
}

}  // namespace talus::render

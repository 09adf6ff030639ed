#include "render/water_shading.h"

#include <algorithm>

namespace talus {
namespace {

gpu::Program water_program(std::vector<std::string> defines) {
    return gpu::Program({"render/block.vert", "render/water.frag"}, std::move(defines));
}

}  // namespace

WaterShading::WaterShading()
    : dry_(water_program({"DRY 1"})),
      mirroring_(water_program({"MIRRORS_GROUND 1"})),
      quick_(water_program({})) {}

void WaterShading::draw(const ShadeFrame& frame, const WaterSurface& water, const gpu::Texture& colours) {
    const Grid& grid = frame.terrain.grid();
    list_.make(water.target().hits(), frame.width, frame.height);
    gpu::Program& program = frame.settings.quick ? quick_ : mirroring_;
    set_camera(program, grid, frame.camera, frame.width, frame.height);
    frame.pyramid.bind(program, frame.terrain);
    frame.pyramid.lowest.bind_sampled(2);
    water.level().bind_sampled(3);
    frame.hits.bind_sampled(4);
    water.target().hits().bind_sampled(5);
    colours.bind_sampled(6);
    frame.terrain.water->front.bind_sampled(9);
    program.set("sun", glm::vec3(frame.settings.sun));
    program.set("extent_m", static_cast<float>(std::max(grid.width_m(), grid.height_m())));
    program.set("pixel_angle", static_cast<float>(pixel_at_one_metre(frame.camera, frame.height)));
    const glm::ivec2 size(frame.width, frame.height);
    draw_blocks(dry_, frame.target, size, list_.nothing(), gpu::Depth::none);
    draw_blocks(program, frame.target, size, list_.something(), gpu::Depth::none);
}

}  // namespace talus

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

void WaterShading::draw(const Terrain& terrain, const Pyramid& ground, const WaterSurface& water,
                        const Camera& camera, const ViewSettings& settings, int width, int height,
                        const gpu::Texture& hits, const gpu::Texture& colours,
                        const gpu::Framebuffer& target) {
    const Grid& grid = terrain.grid();
    list_.make(water.target().hits(), width, height);
    gpu::Program& program = settings.quick ? quick_ : mirroring_;
    set_camera(program, grid, camera, width, height);
    ground.bind(program, terrain);
    ground.lowest.bind_sampled(2);
    water.level().bind_sampled(3);
    hits.bind_sampled(4);
    water.target().hits().bind_sampled(5);
    colours.bind_sampled(6);
    terrain.water->front.bind_sampled(9);
    program.set("sun", glm::vec3(settings.sun));
    program.set("extent_m", static_cast<float>(std::max(grid.width_m(), grid.height_m())));
    program.set("pixel_angle", static_cast<float>(pixel_at_one_metre(camera, height)));
    draw_blocks(dry_, target, {width, height}, list_.nothing(), gpu::Depth::none);
    draw_blocks(program, target, {width, height}, list_.something(), gpu::Depth::none);
}

}  // namespace talus

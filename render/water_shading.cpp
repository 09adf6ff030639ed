#include "render/water_shading.h"

#include <algorithm>

namespace talus {

void WaterShading::draw(const Terrain& terrain, const Pyramid& ground, const WaterSurface& water,
                        const Camera& camera, const ViewSettings& settings, int width, int height,
                        const gpu::Texture& hits, const gpu::Texture& colours,
                        const gpu::Framebuffer& target) {
    const Grid& grid = terrain.grid();
    set_camera(program_, grid, camera, width, height);
    ground.bind(program_, terrain);
    ground.lowest.bind_sampled(2);
    water.level().bind_sampled(3);
    hits.bind_sampled(4);
    water.target().hits().bind_sampled(5);
    colours.bind_sampled(6);
    terrain.water->front.bind_sampled(9);
    program_.set("sun", glm::vec3(settings.sun));
    program_.set("extent_m", static_cast<float>(std::max(grid.width_m(), grid.height_m())));
    program_.set("pixel_angle", static_cast<float>(pixel_at_one_metre(camera, height)));
    target.bind({0, 0, width, height});
    program_.draw_fullscreen();
}

}  // namespace talus

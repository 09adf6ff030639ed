#include "render/tiled/tiled_rays.h"

namespace talus::render {
namespace {

RayOptions tiled_ray_options(Detail detail) {
    RayOptions options;
    options.defines = {detail == Detail::steps ? "COUNT_STEPS" : "TELL_SLOT"};
    options.tiled = true;
    return options;
}

}  // namespace

TiledRays::TiledRays(Detail detail) : rays_(tiled_ray_options(detail)) {}

void TiledRays::cast(const TiledSurface& surface, const Camera& camera, glm::ivec2 size,
                     const gpu::Framebuffer& hits) {
    const RayPicture picture{size, hits, [&](gpu::Program& program) { surface.bind(program, camera, size); }};
    rays_.cast_beams(picture);
    rays_.draw(picture);
}

}  // namespace talus::render

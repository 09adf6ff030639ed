#include "render/tiled/tiled_rays.h"

#include <utility>

namespace talus::render {
namespace {

RayOptions tiled_ray_options(std::vector<std::string> defines) {
    RayOptions options;
    options.defines = std::move(defines);
    options.tiled = true;
    return options;
}

}  // namespace

TiledRays::TiledRays(Detail detail)
    : defines_({detail == Detail::steps ? "COUNT_STEPS" : "TELL_SLOT"}), rays_(tiled_ray_options(defines_)) {}

TiledRays::TiledRays(glm::ivec2 hole_first, glm::ivec2 hole_end)
    : hole_(Hole{hole_first, hole_end}),
      defines_({"TELL_SLOT", "HOLE"}),
      rays_(tiled_ray_options(defines_)) {}

void set_hole(gpu::Program& program, glm::ivec2 first, glm::ivec2 end) {
    program.set("hole_first", first);
    program.set("hole_end", end);
}

void TiledRays::cast(const TiledSurface& surface, const Camera& camera, glm::ivec2 size,
                     const gpu::Framebuffer& hits) {
    const RayPicture picture{size, hits, [&](gpu::Program& program) {
                                 surface.bind(program, camera, size);
                                 if (hole_) set_hole(program, hole_->first, hole_->end);
                             }};
    if (camera.is_parallel()) {
        if (!parallel_) {
            std::vector<std::string> defines = defines_;
            defines.emplace_back("PARALLEL");
            parallel_.emplace(std::vector<std::string>{"render/fullscreen.vert", "render/tiled.frag"},
                              std::move(defines));
        }
        picture.bind(*parallel_);
        hits.bind({0, 0, size.x, size.y});
        parallel_->draw_fullscreen();
        return;
    }
    rays_.cast_beams(picture);
    rays_.draw(picture);
}

}  // namespace talus::render

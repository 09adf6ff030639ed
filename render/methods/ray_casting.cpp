#include "render/methods/ray_casting.h"

#include "render/methods/beams.h"

namespace talus {
namespace {

struct Rays {
    explicit Rays(const std::vector<std::string>& defines)
        : everywhere({"render/fullscreen.vert", "render/exact.frag"}, defines),
          in_blocks({"render/block.vert", "render/exact.frag"}, defines) {}
    Beams beams;
    gpu::Program everywhere;
    gpu::Program in_blocks;
};

}  // namespace

Method cast_rays(const std::vector<std::string>& defines) {
    auto rays = std::make_shared<Rays>(defines);
    const auto draw = [rays](const Frame& frame) {
        rays->beams.cast(frame);
        gpu::Program& program = frame.redraw ? rays->in_blocks : rays->everywhere;
        frame.pyramid.bind(program, frame.terrain);
        set_camera(program, frame.terrain.grid(), frame.camera, frame.width, frame.height);
        rays->beams.bind();
        if (frame.redraw) frame.redraw->list();
        frame.hits.bind({0, 0, frame.width, frame.height});
        if (frame.redraw)
            frame.redraw->draw(program, gpu::Depth::none);
        else
            program.draw_fullscreen();
    };
    return {draw, [rays] { return MethodFigures{0, 0, rays->beams.bytes()}; }};
}

}  // namespace talus

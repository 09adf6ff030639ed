#include "render/methods/beams.h"

namespace talus {
namespace {

struct Exact {
    explicit Exact(Detail detail)
        : rays({"render/fullscreen.vert", "render/exact.frag"}, detail_defines(detail)),
          ray_blocks({"render/block.vert", "render/exact.frag"}, detail_defines(detail)) {}
    Beams beams;
    gpu::Program rays;
    gpu::Program ray_blocks;
};

}  // namespace

Method make_exact(Detail detail) {
    auto exact = std::make_shared<Exact>(detail);
    return [exact](const Frame& frame) {
        exact->beams.cast(frame);
        gpu::Program& rays = frame.redraw ? exact->ray_blocks : exact->rays;
        frame.pyramid.bind(rays, frame.terrain);
        set_camera(rays, frame.terrain.grid(), frame.camera, frame.width, frame.height);
        exact->beams.bind();
        if (frame.redraw) frame.redraw->list();
        frame.hits.bind({0, 0, frame.width, frame.height});
        if (frame.redraw)
            frame.redraw->draw(rays, gpu::Depth::none);
        else
            rays.draw_fullscreen();
    };
}

}  // namespace talus

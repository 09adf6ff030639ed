#include "render/methods/beams.h"

namespace talus {
namespace {

struct Exact {
    explicit Exact(Detail detail)
        : rays({"render/fullscreen.vert", "render/exact.frag"}, detail_defines(detail)) {}
    Beams beams;
    gpu::Program rays;
};

}  // namespace

Method make_exact(Detail detail) {
    auto exact = std::make_shared<Exact>(detail);
    return [exact](const Frame& frame) {
        exact->beams.cast(frame);
        frame.pyramid.bind(exact->rays, frame.terrain);
        set_camera(exact->rays, frame.terrain.grid(), frame.camera, frame.width, frame.height);
        exact->beams.bind();
        frame.hits.bind({0, 0, frame.width, frame.height});
        exact->rays.draw_fullscreen();
    };
}

}  // namespace talus

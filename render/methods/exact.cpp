#include "render/methods/method.h"

namespace talus {

Method make_exact(bool count_steps) {
    std::vector<std::string> defines;
    if (count_steps) defines.emplace_back("COUNT_STEPS");
    auto program = std::make_shared<gpu::Program>(
        std::vector<std::string>{"render/fullscreen.vert", "render/exact.frag"}, defines);
    return [program](const Frame& frame) {
        frame.pyramid.bind(*program, frame.terrain);
        set_camera(*program, frame.terrain.grid(), frame.camera, frame.width, frame.height);
        program->set("start_level", 5);
        frame.hits.bind({0, 0, frame.width, frame.height});
        program->draw_fullscreen();
    };
}

}  // namespace talus

#include "render/methods/parallel.h"

#include <memory>

#include "render/methods/ray_casting.h"

namespace talus::render {
namespace {

std::vector<std::string> parallel_defines(Detail detail) {
    std::vector<std::string> defines = detail_defines(detail);
    defines.emplace_back("PARALLEL");
    return defines;
}

// A program for the whole picture, and one for blocks of it.
struct ParallelRays {
    explicit ParallelRays(const std::vector<std::string>& defines)
        : whole(std::vector<std::string>{"render/fullscreen.vert", "render/exact.frag"}, defines),
          blocks(std::vector<std::string>{"render/block.vert", "render/exact.frag"}, defines) {}
    gpu::Program whole;
    gpu::Program blocks;
};

}  // namespace

Method make_parallel(Detail detail) {
    auto rays = std::make_shared<ParallelRays>(parallel_defines(detail));
    const auto draw = [rays](const Frame& frame) {
        const RayPicture picture = ray_picture(frame);
        if (frame.redraw) {
            frame.redraw->list();
            picture.bind(rays->blocks);
            frame.redraw->draw(rays->blocks, frame.hits, gpu::Depth::none);
            return;
        }
        picture.bind(rays->whole);
        frame.hits.bind({0, 0, frame.width, frame.height});
        rays->whole.draw_fullscreen();
    };
    return {draw, [] { return MethodFigures{}; }};
}

}  // namespace talus::render

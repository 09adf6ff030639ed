#include "render/methods/method.h"

namespace talus::render {
namespace {

const Parameter& samples() {
    static const Parameter declared =
        whole("render.relief_samples", 64, 1, 16384, "",
              "Samples along the ray of the method relief: what is thinner than their spacing is missed.")
            .labelled("Samples along ray");
    return declared;
}

const Parameter& halvings() {
    static const Parameter declared =
        whole("render.relief_halvings", 25, 0, 30, "",
              "How often the method relief halves the interval in which a ray goes under the ground.")
            .labelled("Halvings");
    return declared;
}

}  // namespace

std::vector<Parameter> relief_parameters() {
    return {samples(), halvings()};
}

std::vector<PixelKind> relief_kinds(const OwnNumbers&) {
    return {{2, "sampled rays"}};
}

Method make_relief(Detail detail) {
    auto program = std::make_shared<gpu::Program>(
        std::vector<std::string>{"render/fullscreen.vert", "render/relief.frag"}, detail_defines(detail));
    const auto draw = [program](const Frame& frame) {
        frame.pyramid.bind(*program, frame.terrain);
        set_camera(*program, frame.terrain.grid(), frame.camera, frame.width, frame.height);
        program->set("samples", static_cast<int>(own_number(frame.numbers, samples())));
        program->set("halvings", static_cast<int>(own_number(frame.numbers, halvings())));
        frame.hits.bind({0, 0, frame.width, frame.height});
        program->draw_fullscreen();
    };
    return {draw, [] { return MethodFigures{}; }};
}

}  // namespace talus::render

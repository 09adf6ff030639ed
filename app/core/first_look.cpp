#include "app/core/first_look.h"

namespace talus::app {

render::Camera first_look(const Parameters& view, const Grid& grid, glm::dvec2 heights_m, double aspect,
                          bool all_around) {
    const render::Framing framing{aspect, view.number("camera.fov_deg"), all_around};
    return view.choice("camera.mode") == "top" ? render::top_view(grid, heights_m.y, framing)
                                               : render::overview(grid, heights_m.x, heights_m.y, framing);
}

}  // namespace talus::app

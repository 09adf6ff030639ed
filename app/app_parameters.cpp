#include "app/app_parameters.h"

#include "render/view.h"
#include "sim/passes/brush.h"
#include "sim/simulation_parameters.h"

namespace talus {

std::vector<Parameter> app_parameters() {
    return {
        choice("brush.mode", "raise", {"raise", "lower", "smooth", "flatten"},
               "What a stroke does; flatten: to the height where it began."),
        number("brush.radius_m", 250, 1e-2, 1e6, "m",
               "Reach of the brush; unless set, it follows the terrain's size."),
        number("brush.rate_m_per_s", 60, 0, 1e6, "m/s",
               "Raise and lower: metres a second in the middle; unless set, it follows the radius."),
        number("brush.blend_per_s", 4, 0, 1000, "1/s",
               "Smooth and flatten: share of the way a second in the middle."),
        number("brush.falloff", 1, 0, 1, "",
               "How much of the radius fades out: 0 a hard edge, 1 soft all the way."),
        choice("brush.material", "bedrock", material_names(),
               "What raising adds; lowering takes water alone where it is water. Hardness, mask and rain are "
               "painted: raise paints, lower wipes."),
        number("brush.rain", 100, 0, 1e4, "mm/h", "Rain that the brush paints where its material is rain."),
        choice("camera.mode", "orbit", {"orbit", "fly", "walk"},
               "Orbit turns about a point on the ground; fly moves with W A S D, Q and E; walk keeps the eye "
               "over the "
               "ground."),
        number("camera.eye_height_m", 1.8, 1e-2, 1e4, "m", "Walking: the eye over the ground."),
        number("camera.walk_m_per_s", 10, 1e-2, 1e6, "m/s", "Walking: speed."),
        toggle("camera.collision", true,
               "The ground stops the camera; off: it may go below, where the ground is solid."),
        number("camera.fov_deg", 50, 5, 120, "°", "Vertical field of view."),
        number("camera.speed_m_per_s", 500, 1e-2, 1e6, "m/s",
               "Speed of flying; unless set, it follows the terrain's size."),
        number("time.speed", 1, 1e-3, 1e6, "s/s", "Simulated seconds a second of play."),
        whole("undo.memory_mib", 1024, 1, 1 << 20, "MiB",
              "Memory that undo may take; the oldest entries go first."),
    };
}

std::vector<Parameter> all_parameters() {
    std::vector<Parameter> all = simulation_parameters();
    for (auto& more : {render_parameters(), app_parameters()})
        all.insert(all.end(), more.begin(), more.end());
    return all;
}

}  // namespace talus

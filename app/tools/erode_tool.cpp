#include <algorithm>

#include "app/tools/tools.h"

namespace talus::app {
namespace {

void erode(const ToolUse& use, Dab& dab) {
    ErodeDab how;
    how.rain_mm_per_h = use.parameters.number("erode.rain_mm_per_h");
    how.acceleration = use.parameters.number("erode.acceleration");
    // That of a click ends when its load has settled.
    constexpr double shortest_s = 1e-3;
    how.time_s = std::max(use.parameters.number("erode.speed") * use.wall_s, shortest_s);
    dab.effect = how;
}

}  // namespace

Tool erode_tool() {
    return {
        .name = "erode",
        .icon = "1,3 15,3; 4,3 6,8 5,14; 8,3 8,9 9,14; 12,3 11,8 13,14",
        .how_to = "Hold: rain gathers, carves and settles, under the brush alone.",
        .shape = erode,
        .settings = {"erode.acceleration", "erode.rain_mm_per_h", "erode.speed"},
        .strength = "erode.acceleration",
        .course = StrokeCourse::flows,
        .parameters = {
            number("erode.rain_mm_per_h", ErodeDab().rain_mm_per_h, 0, 1e4, "mm/h",
                   "Erode: rain in the middle of the brush.")
                .labelled("Rain")
                .once("erode.rain"),
            number(
                "erode.speed", 60, 1e-3, 1e6, "s/s",
                "Erode: simulated seconds a second; unless set, it follows the spacing. A wide brush takes "
                "its time.")
                .labelled("Speed"),
            number(
                "erode.acceleration", ErodeDab().acceleration, 1, 1e5, "",
                "Erode: how often what water takes and leaves counts for the ground. How easily rock gives "
                "way is "
                "erosion.erodibility and erosion.bedrock_erodibility.")}};
}

}  // namespace talus::app

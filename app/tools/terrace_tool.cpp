#include "app/tools/tools.h"

namespace talus::app {
namespace {

void terrace(const ToolUse& use, Dab& dab) {
    dab.target_m = 0;
    dab.effect = TerraceDab{use.parameters.number("terrace.step_m"), use.parameters.number("terrace.flat")};
}

}  // namespace

Tool terrace_tool() {
    return {.name = "terrace",
            .icon = "1,14 5,14 5,10 9,10 9,6 13,6 13,2 15,2",
            .how_to = "Cuts steps of equal height. Shift smooths.",
            .shape = terrace,
            .settings = {"terrace.step_m", "terrace.flat", "brush.blend_per_s"},
            .strength = "brush.blend_per_s",
            .parameters = {number("terrace.step_m", TerraceDab().step_m, 1e-2, 1e5, "m",
                                  "Terrace: height of a step; unless set, it follows the terrain's height."),
                           number("terrace.flat", TerraceDab().flat, 0, 0.99, "",
                                  "Terrace: share of a step that is level.")
                               .labelled("Level part")}};
}

}  // namespace talus::app

// Tools that move the ground up and down.
#include "app/tools/tools.h"

namespace talus::app {
namespace {

constexpr const char* turns_around = "Ctrl turns it around, Shift smooths.";

void raise(const ToolUse& use, Dab& dab) {
    dab.effect = effect_of(use.inverted ? BrushMode::lower : BrushMode::raise);
}

void lower(const ToolUse& use, Dab& dab) {
    dab.effect = effect_of(use.inverted ? BrushMode::raise : BrushMode::lower);
}

void smooth(const ToolUse&, Dab& dab) {
    dab.effect = SmoothDab{};
}

void flatten(const ToolUse&, Dab& dab) {
    dab.effect = FlattenDab{};
}

void bring_to_height(const ToolUse& use, Dab& dab) {
    dab.effect = FlattenDab{};
    dab.target_m = use.parameters.number("brush.height_m");
}

void ramp(const ToolUse&, Dab& dab) {
    dab.effect = RampDab{};
    dab.blend = 1;
}

}  // namespace

Tool raise_tool() {
    return {.name = "raise",
            .icon = "1,14 5,9 8,11 11,9 15,14; 8,8 8,1; 5,4 8,1 11,4",
            .how_to = turns_around,
            .shape = raise,
            .settings = {"brush.rate_m_per_s", "brush.material"},
            .strength = "brush.rate_m_per_s"};
}

Tool lower_tool() {
    return {.name = "lower",
            .icon = "1,7 5,14 11,14 15,7; 8,1 8,11; 5,8 8,11 11,8",
            .how_to = turns_around,
            .shape = lower,
            .settings = {"brush.rate_m_per_s"},
            .strength = "brush.rate_m_per_s"};
}

Tool smooth_tool() {
    return {.name = "smooth",
            .icon = "1,11 3,8 5,7 7,8 9,10 11,10 13,8 15,5",
            .how_to = "Brings the ground nearer to the mean of its neighbours.",
            .shape = smooth,
            .settings = {"brush.blend_per_s"},
            .strength = "brush.blend_per_s"};
}

Tool flatten_tool() {
    return {.name = "flatten",
            .icon = "1,12 15,12; 8,2 8,9; 5,6 8,9 11,6",
            .how_to = "To the height where the stroke begins.",
            .shape = flatten,
            .settings = {"brush.blend_per_s"},
            .strength = "brush.blend_per_s"};
}

Tool height_tool() {
    return {.name = "height",
            .icon = "2,14 14,14; 5,2 5,14; 5,2 9,2; 5,6 8,6; 5,10 8,10",
            .how_to = "Ctrl and a click pick the height under the mouse.",
            .shape = bring_to_height,
            .settings = {"brush.height_m", "brush.blend_per_s"},
            .strength = "brush.blend_per_s",
            .picks_height = true,
            .history_name = "height"};
}

Tool ramp_tool() {
    return {.name = "ramp",
            .icon = "1,14 15,14 15,4 1,14",
            .how_to = "Press where the slope begins, let go where it ends.",
            .shape = ramp,
            .course = StrokeCourse::at_end};
}

}  // namespace talus::app

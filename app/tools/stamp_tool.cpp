#include <algorithm>

#include "app/tools/tools.h"

namespace talus::app {
namespace {

void press_stamp(const ToolUse& use, Dab& dab) {
    const Parameters& p = use.parameters;
    const Stamp* stamp = use.stamp;
    StampDab how;
    dab.blend = 1;
    dab.amount_m = p.is_given("stamp.relief_m") || !stamp ? p.number("stamp.relief_m")
                                                          : natural_relief_m(*stamp, 2 * dab.radius_m);
    if (use.inverted) dab.amount_m = -dab.amount_m;
    how.mode = p.choice_as<StampMode>("stamp.mode");
    how.turn_deg = p.number("stamp.turn_deg");
    how.mirrored = p.toggle("stamp.mirrored");
    // The longer side is as wide as the brush; the corners lie within its reach.
    how.half_m = glm::dvec2(dab.radius_m);
    if (stamp) {
        how.zero = zero_of(*stamp, p.choice_as<StampZero>("stamp.zero"));
        const glm::dvec2 size(stamp->grid.width_m(), stamp->grid.height_m());
        how.half_m = dab.radius_m * size / std::max(size.x, size.y);
    }
    dab.radius_m = 1.001 * glm::length(how.half_m);
    dab.effect = how;
}

}  // namespace

Tool stamp_tool() {
    return {
        .name = "stamp",
        .icon = "5,2 11,2 11,6 9,8 9,10 14,10 14,14 2,14 2,10 7,10 7,8 5,6 5,2",
        .how_to = "Ctrl turns it around, Shift smooths.",
        .shape = press_stamp,
        .settings = {"stamp.mode", "stamp.relief_m", "stamp.zero", "stamp.turn_deg", "stamp.mirrored"},
        .strength = "stamp.relief_m",
        .course = StrokeCourse::stamps,
        .parameters = {
            choice("stamp.mode", StampDab().mode, stamp_mode_names(),
                   "Stamp: added to the ground; higher and lower: the ground gives way only where it is in "
                   "the way; "
                   "replace: the ground becomes the stamp.")
                .labelled("Pressed"),
            number(
                "stamp.relief_m", 100, 0, 1e5, "m",
                "Height of the stamp; unless set, as it came, or of the shelf's in proportion to the brush.")
                .labelled("Height"),
            choice(
                "stamp.zero", "border", stamp_zero_names(),
                "Stamp: which of its heights leaves the ground as it is, so that what is lower digs: that of "
                "its border, its lowest sample, or 0 m of the file.")
                .labelled("Zero at"),
            number("stamp.turn_deg", StampDab().turn_deg, -360, 360, "°",
                   "The stamp turned, counterclockwise.")
                .labelled("Turned by"),
            toggle("stamp.mirrored", StampDab().mirrored, "The stamp mirrored, west for east.")}};
}

}  // namespace talus::app

#pragma once
#include <string>
#include <vector>

#include "sim/terrain/reshape.h"

namespace talus {

namespace glsl {
#include "maths/mask_kinds.glsl"
}

/// What a mask is made of: height (m), slope (degrees), curvature (1/km: crests positive, hollows negative),
/// depth of water, now and at its largest (m), when it arrived (s), flow (m³), wear and deposition by all
/// together (m), regolith (m), the ground's change since the start (m), itself (to invert it), everything,
/// the distance from a rectangle (m).
enum class MaskSource {
    height = glsl::mask_source_height,
    slope = glsl::mask_source_slope,
    curvature = glsl::mask_source_curvature,
    depth = glsl::mask_source_depth,
    largest_depth = glsl::mask_source_largest_depth,
    arrival = glsl::mask_source_arrival,
    flow = glsl::mask_source_flow,
    wear = glsl::mask_source_wear,
    deposition = glsl::mask_source_deposition,
    regolith = glsl::mask_source_regolith,
    difference = glsl::mask_source_difference,
    itself = glsl::mask_source_itself,
    everything = glsl::mask_source_everything,
    rectangle = glsl::mask_source_rectangle
};
const std::vector<std::string>& mask_source_names();
/// How it meets what is painted: takes its place, adds to it, keeps what both have, takes it away.
enum class MaskJoin {
    replace = glsl::mask_join_replace,
    add = glsl::mask_join_add,
    intersect = glsl::mask_join_intersect,
    subtract = glsl::mask_join_subtract
};
const std::vector<std::string>& mask_join_names();

/// The mask is 1 from `low` to `high` and falls to 0 over `fade` beyond each.
struct MaskSettings {
    MaskSource source = MaskSource::slope;
    double low = 0;
    double high = 0;
    double fade = 0;
    MaskJoin join = MaskJoin::replace;
    bool inverted = false;
    Rectangle rectangle = {};  ///< for its source, m from the south-west sample
    bool operator==(const MaskSettings&) const = default;
};
/// Throws talus::Error that names the field when no mask can be made so.
void check_mask(const MaskSettings& settings);

}  // namespace talus

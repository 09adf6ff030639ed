// Froude number: speed over that of long waves.
uniform real froude_scale;
uniform real gravity;  // m/s²
#include "render/flow.glsl"

vec3 view_colour(ViewPoint point) {
    Flow flow = flow_at(point.place);
    if (flow.depth_m < wet_depth_m) return bare * point.lit;
    return colour_map(length(flow.velocity) / sqrt(gravity * flow.depth_m) / froude_scale);
}

// The water's depth.
uniform real depth_scale_m;
#include "render/flow.glsl"

vec3 view_colour(ViewPoint point) {
    Flow flow = flow_at(point.place);
    if (flow.depth_m < wet_depth_m) return bare * point.lit;
    return colour_map(flow.depth_m / depth_scale_m);
}

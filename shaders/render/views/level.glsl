// The water's level.
uniform real level_middle_m;
uniform real level_scale_m;  // from the middle to the ends
#include "render/flow.glsl"

vec3 view_colour(ViewPoint point) {
    Flow flow = flow_at(point.place);
    if (flow.depth_m < wet_depth_m) return bare * point.lit;
    float level = (height_at(point.place) + flow.depth_m) + (origin_height_m.x - level_middle_m);
    return difference_map(0.5 + 0.5 * level / level_scale_m);
}

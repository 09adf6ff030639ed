// The water's level.
uniform real level_middle_m;
uniform real level_scale_m;  // from the middle to the ends
#include "render/flow.glsl"

// Over the middle of the scale.
float level_over_middle(vec2 place, float depth_m) { return (height_at(place) + depth_m) + (origin_height_m.x - level_middle_m); }

float view_value(vec2 place) {
    Flow flow = flow_at(place);
    return flow.depth_m < wet_depth_m ? 0.0 : abs(level_over_middle(place, flow.depth_m));
}

vec3 view_colour(ViewPoint point) {
    Flow flow = flow_at(point.place);
    if (flow.depth_m < wet_depth_m) return bare * point.lit;
    return difference_map(0.5 + 0.5 * level_over_middle(point.place, flow.depth_m) / level_scale_m);
}

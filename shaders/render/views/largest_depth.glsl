// The largest depth so far.
uniform real depth_scale_m;
#include "render/inundation.glsl"

float view_value(vec2 place) {
    float depth_m = inundation_at(place).x;
    return depth_m < wet_depth_m ? 0.0 : depth_m;
}

vec3 view_colour(ViewPoint point) {
    float depth_m = view_value(point.place);
    return depth_m > 0.0 ? colour_map(depth_m / depth_scale_m) : bare * point.lit;
}

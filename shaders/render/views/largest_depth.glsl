// The largest depth so far.
uniform real depth_scale_m;
#include "render/inundation.glsl"

vec3 view_colour(ViewPoint point) {
    vec2 flood = inundation_at(point.place);
    if (flood.x < wet_depth_m) return bare * point.lit;
    return colour_map(flood.x / depth_scale_m);
}

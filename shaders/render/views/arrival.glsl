// When water arrived.
uniform real arrival_scale_s;
#include "render/inundation.glsl"

vec3 view_colour(ViewPoint point) {
    vec2 flood = inundation_at(point.place);
    if (flood.x < wet_depth_m) return bare * point.lit;
    return colour_map(flood.y / arrival_scale_s);
}

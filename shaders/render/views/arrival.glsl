// When water arrived.
uniform real arrival_scale_s;
#include "render/inundation.glsl"

float view_value(vec2 place) {
    vec2 flood = inundation_at(place);
    return flood.x < wet_depth_m ? 0.0 : flood.y;
}

vec3 view_colour(ViewPoint point) {
    vec2 flood = inundation_at(point.place);
    if (flood.x < wet_depth_m) return bare * point.lit;
    return colour_map(flood.y / arrival_scale_s);
}

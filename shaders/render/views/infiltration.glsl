// Painted infiltration.
#include "render/land_cover.glsl"
uniform sampler2D layer;          // Manning's n and infiltration, each with its share
uniform real infiltration_scale;  // mm/h

float view_value(vec2 place) { return land_cover_value(layer_at(layer, place, 0).zw); }

vec3 view_colour(ViewPoint point) {
    return land_cover_colour(layer_at(layer, point.place, 0).zw, infiltration_scale) * point.lit;
}

// Solid in the water: how high it would stand on the ground.
#include "sim/water_layout.glsl"
uniform sampler2D layer;  // m, two words, two ghost samples around
uniform real suspended_scale_mm;

float view_value(vec2 place) { return 1e3 * layer_at(layer, place, water_ghosts).x; }

vec3 view_colour(ViewPoint point) {
    float mm = view_value(point.place);
    return mm > 1e-3 * suspended_scale_mm ? colour_map(mm / suspended_scale_mm) : bare * point.lit;
}

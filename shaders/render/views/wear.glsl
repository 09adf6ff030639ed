// Ground that was taken so far.
#include "render/worn.glsl"

float view_value(vec2 place) { return worn_at(place).x; }

vec3 view_colour(ViewPoint point) { return worn_colour(view_value(point.place), point.lit); }

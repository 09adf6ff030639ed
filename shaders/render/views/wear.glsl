// Ground that was taken so far.
#include "render/worn.glsl"

vec3 view_colour(ViewPoint point) { return worn_colour(worn_at(point.place).x, point.lit); }

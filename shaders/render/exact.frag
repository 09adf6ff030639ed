// Method "exact": every pixel's ray walks the pyramid to the bilinear surface.
#ifdef COUNT_STEPS
const bool count_steps = true;
#else
const bool count_steps = false;
#endif
#include "render/surface.glsl"
#include "render/picture.glsl"
#include "maths/cast.glsl"

layout(location = 0) out vec2 hit_out;  // distance along the ray in metres (infinity: nothing hit), steps

uniform int start_level;

void main() {
    CastHit hit = cast_ray(origin_cell, origin_fraction, pixel_ray(picture_position()), 0.0, start_level, 0.0);
    hit_out = vec2(hit.distance_m < 0.0 ? uintBitsToFloat(0x7f800000u) : hit.distance_m, float(hit.steps));
}

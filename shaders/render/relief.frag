// Method "relief": every pixel's ray is sampled from where it enters the terrain's box, or from the eye within it, to where
// it leaves (Policarpo, Oliveira & Comba 2005).
const bool count_steps = true;
#include "render/surface.glsl"
#include "render/picture.glsl"
#include "maths/cast.glsl"
#include "maths/march.glsl"

layout(location = 0) out vec2 hit_out;  // distance along the ray in metres (infinity: nothing hit), detail
uniform sampler2D bottoms;
uniform int samples;
uniform int halvings;

void main() {
    real lowest = (texelFetch(bottoms, whole_texel(), 0).r - origin_height_m.x) - origin_height_m.y;
    CastHit hit = march_box(int2(0, 0), patches, real2(lowest, load_highest()), origin_cell, origin_fraction,
                            pixel_ray(picture_position()), samples, halvings);
    hit_out = vec2(hit.distance_m < 0.0 ? uintBitsToFloat(0x7f800000u) : hit.distance_m, float(hit.steps));
#ifdef TELL_KIND
    hit_out.y = hit.distance_m < 0.0 ? 0.0 : 2.0;
#endif
}

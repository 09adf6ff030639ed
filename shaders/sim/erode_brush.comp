// The ground around an erode dab, copied into a terrain of its own, where rain and mask are as strong as the dab.
layout(local_size_x = 16, local_size_y = 16) in;
#include "sim/samples.glsl"

layout(rgba32f) uniform readonly image2D painted;
layout(rgba32f) uniform writeonly image2D painted_out;

uniform int2 window_corner;   // on the map
uniform int2 window_samples;
uniform int is_painted;
uniform real erode_rain;      // mm/h at full weight

real painted_mask(int2 at) { return is_painted != 0 ? imageLoad(painted, at).y : real(0); }
#include "sim/dab.glsl"
#include "maths/brush_weight.glsl"
#include "maths/ground_height.glsl"

void main() {
    int2 at = int2(gl_GlobalInvocationID.xy);
    if (at.x >= window_samples.x || at.y >= window_samples.y) return;
    int2 there = window_corner + at;
    real4 solid = load_solid(there);
    imageStore(solid_out, at, solid);
    imageStore(ground_out, at, vec4(ground_height(solid)));
    real weight = brush_weight_at(there);
    real hardness = is_painted != 0 ? imageLoad(painted, there).x : real(0);
    imageStore(painted_out, at, vec4(hardness, weight, erode_rain * weight, real(0)));
}

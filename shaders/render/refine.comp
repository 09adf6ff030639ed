// Adds a picture, shifted within its pixels, to the sum of those before it, and writes their mean. Light adds up in linear
// colours; pictures hold their square roots.
layout(local_size_x = 32, local_size_y = 8) in;
#include "maths/glsl_types.glsl"

uniform sampler2D picture;
layout(rgba32f) uniform image2D sum;
layout(rgba8) uniform writeonly image2D mean;

uniform int2 size;
uniform int samples;  // with this one; 1: it is the first

void main() {
    int2 at = int2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, size))) return;
    real3 colour = texelFetch(picture, at, 0).rgb;
    real3 light = colour * colour;
    if (samples > 1) light += imageLoad(sum, at).rgb;
    imageStore(sum, at, vec4(light, 1.0));
    if (samples > 1) imageStore(mean, at, vec4(sqrt(light / real(samples)), 1.0));
}

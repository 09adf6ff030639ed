// The ground's distance as depth of the window's pixels: each takes that of the picture's pixel that it shows.
#include "maths/glsl_types.glsl"

uniform sampler2D hits;

uniform int2 picture;     // pixels
uniform real2 area_from;   // where the picture lies in the window, pixels
uniform real2 area_size;
uniform real log2_scale;   // depth: 1/2 - log2(metres) / scale

void main() {
    real2 share = (gl_FragCoord.xy - area_from) / area_size;
    int2 at = min(max(int2(floor(share * real2(picture))), int2(0)), picture - 1);
    float distance_m = texelFetch(hits, at, 0).r;
    gl_FragDepth = isinf(distance_m) ? 0.0 : clamp(0.5 - log2(max(distance_m, 1e-20)) / log2_scale, 0.0, 1.0);
}

// Where the backdrop is nearer than the terrain and its water, its picture; else what was there. NEAREST: the distances instead of
// the colours.
#include "maths/glsl_types.glsl"

uniform sampler2D hits;
uniform sampler2D water_hits;
uniform sampler2D backdrop_hits;
uniform sampler2D backdrop_colours;
uniform int watered;

#ifdef NEAREST
layout(location = 0) out vec2 hit_out;
#else
layout(location = 0) out vec4 colour_out;
#endif

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec2 hit = texelFetch(hits, pixel, 0).rg;
    vec2 behind = texelFetch(backdrop_hits, pixel, 0).rg;
#ifdef NEAREST
    hit_out = behind.r < hit.r ? behind : hit;
#else
    float water_m = texelFetch(water_hits, pixel, 0).r;
    float nearest_m = watered == 1 ? min(hit.r, water_m) : hit.r;
    if (!(behind.r < nearest_m)) discard;
    colour_out = vec4(texelFetch(backdrop_colours, pixel, 0).rgb, 1.0);
#endif
}

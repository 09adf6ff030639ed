// The inundation map at a place of the picture. The including side has surface.glsl.
#include "sim/water_layout.glsl"
uniform sampler2D layer;  // largest depth, arrival

// The inundation map between its samples, m and s: of those where water arrived.
vec2 inundation_at(vec2 place) {
    ivec2 cell = clamp(origin_cell + ivec2(floor(place)), ivec2(0), patches - 1);
    vec2 w = clamp(place - vec2(cell - origin_cell), 0.0, 1.0);
    vec2 sum = vec2(0.0);
    float weights = 0.0;
    for (int i = 0; i < 4; ++i) {
        vec2 texel = texelFetch(layer, cell + ivec2(i & 1, i >> 1), 0).rg;
        float weight = ((i & 1) == 0 ? 1.0 - w.x : w.x) * (i < 2 ? 1.0 - w.y : w.y);
        sum.x += weight * texel.x;
        weight = texel.x > 0.0 ? weight : 0.0;
        sum.y += weight * texel.y;
        weights += weight;
    }
    return vec2(sum.x, sum.y / max(weights, 1e-6));
}

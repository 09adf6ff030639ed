// The mask of the whole terrain anew, a group per tile, an invocation per column.
layout(local_size_x = 64) in;
#include "sim/tile_samples.glsl"
#include "maths/glsl_types.glsl"
#include "maths/mask_kinds.glsl"

#include "sim/water_layout.glsl"
layout(rgba32f) uniform image2D painted;
layout(r32f) uniform readonly image2D ground;
#include "sim/tile_stamps.glsl"

uniform int2 samples;
uniform int2 tiles;
uniform real2 cell_m;
const int mask_source = MASK_SOURCE;
uniform real mask_low;
uniform real mask_high;
uniform real mask_fade;
uniform real4 mask_rectangle;
uniform int mask_join;
uniform int mask_inverted;

// What the source reads beside the ground: a number of up to three layers together.
#ifdef LAYERS
layout(LAYER_FORMAT) uniform readonly image2D layer;
#if LAYERS == 3
layout(LAYER_FORMAT) uniform readonly image2D second_layer;
layout(LAYER_FORMAT) uniform readonly image2D third_layer;
#endif
uniform int layers_there;  // a bit for each; another image stands in for one that is not, unread

real number_of(real4 texel) {
#ifdef ARRIVAL
    // Where no water came it has not arrived.
    return texel.x > real(0) ? texel[LAYER_WORD] : real(1e30);
#elif LAYER_WORDS == 2
    precise real number = texel[LAYER_WORD] + texel[LAYER_WORD + 1];
    return number;
#else
    return texel[LAYER_WORD];
#endif
}

real load_layer(int2 at) {
    precise real sum = (layers_there & 1) != 0 ? number_of(imageLoad(layer, at + LAYER_GHOSTS)) : real(ABSENT_LAYER);
#if LAYERS == 3
    sum += (layers_there & 2) != 0 ? number_of(imageLoad(second_layer, at + LAYER_GHOSTS)) : real(0);
    sum += (layers_there & 4) != 0 ? number_of(imageLoad(third_layer, at + LAYER_GHOSTS)) : real(0);
#endif
    return sum;
}
#else
#ifdef DIFFERENCE
layout(rg32f) uniform readonly image2D start;  // m, two words
real load_layer(int2 at) {
    real2 before = imageLoad(start, at).xy;
    precise real change = (imageLoad(ground, at).x - before.x) - before.y;
    return change;
}
#else
real load_layer(int2 at) { return real(0); }
#endif
#endif

real load_ground(int2 at) { return imageLoad(ground, clamp(at, int2(0), samples - 1)).x; }
#include "maths/mask.glsl"

void main() {
    int2 tile = int2(gl_WorkGroupID.xy);
    int2 first = tile * tile_samples + int2(int(gl_LocalInvocationIndex), 0);
    bool changed = false;
    if (first.x < samples.x) {
        for (int row = 0; row < min(tile_samples, samples.y - first.y); ++row) {
            int2 at = first + int2(0, row);
            real4 value = imageLoad(painted, at);
            real made = mask_value(at, load_layer(at), value.y);
            if (mask_inverted != 0) made = real(1) - made;
            real after = mask_joined(value.y, made, mask_join);
            if (after == value.y) continue;
            value.y = after;
            imageStore(painted, at, value);
            changed = true;
        }
    }
    if (changed) stamp_tile(tile.y * tiles.x + tile.x, tile_painted);
}

// The mask of the whole terrain anew, a group per tile, an invocation per column.
layout(local_size_x = 64) in;
#include "sim/tile_samples.glsl"
#include "maths/glsl_types.glsl"
#include "maths/mask_kinds.glsl"

#include "sim/water_layout.glsl"
layout(rgba32f) uniform image2D painted;
layout(r32f) uniform readonly image2D ground;
layout(rgba32f) uniform readonly image2D water;
#include "sim/tile_stamps.glsl"

uniform int2 samples;
uniform int2 tiles;
uniform real2 cell_m;
uniform int mask_source;
uniform real mask_low;
uniform real mask_high;
uniform real mask_fade;
uniform int mask_join;
uniform int mask_inverted;
uniform int has_water;

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
            real depth = has_water != 0 ? imageLoad(water, at + water_ghosts).x : real(0);
            real made = mask_value(at, depth, value.y);
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

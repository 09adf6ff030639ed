// One dab of paint on a rectangle of tiles: a group per tile, an invocation per column. LAND_COVER: of a number with its share behind
// it, which the dab brings nearer to the value and 1, or to nothing and 0.
layout(local_size_x = 64) in;
#include "sim/tile_samples.glsl"
#include "maths/glsl_types.glsl"

#ifdef LAND_COVER
layout(rgba32f) uniform readonly image2D painted;
layout(rgba32f) uniform image2D land_cover;
#else
layout(rgba32f) uniform image2D painted;
#endif
#include "sim/tile_stamps.glsl"

uniform int2 samples;
uniform int2 tiles;
uniform int painted_word;  // of the texel

real painted_mask(int2 at) { return imageLoad(painted, at).y; }
#include "sim/dab.glsl"
#include "maths/brush_weight.glsl"

// It gets there: a trace that nobody sees would keep its tile awake. `scale`: of what is hardly anything.
real painted_nearer(real before, real target, real weight, real scale) {
    precise real way = weight * (target - before);
    precise real nearer = before + way;
    bool there = abs(target - nearer) <= real(1e-3) * max(target, scale) && way != real(0);
    return there ? target : nearer;
}

void main() {
    int2 tile = first_tile + int2(gl_WorkGroupID.xy);
    int2 first = tile * tile_samples + int2(int(gl_LocalInvocationIndex), 0);
    bool changed = false;
    if (first.x < samples.x) {
        for (int row = 0; row < min(tile_samples, samples.y - first.y); ++row) {
            int2 at = first + int2(0, row);
            precise real weight = brush_weight_at(at) * dab_blend;
#ifdef LAND_COVER
            real4 value = imageLoad(land_cover, at);
            real2 before = painted_word == 0 ? value.xy : value.zw;
            real share = dab_takes == 1 ? real(0) : real(1);
            real2 after = real2(painted_nearer(before.x, dab_target_m.x * share, weight, real(1e-2)),
                                painted_nearer(before.y, share, weight, real(1)));
            if (after.y == real(0)) after.x = real(0);
            if (after == before) continue;
            value = painted_word == 0 ? real4(after, value.zw) : real4(value.xy, after);
            imageStore(land_cover, at, value);
#else
            real4 value = imageLoad(painted, at);
            real before = painted_word == 0 ? value.x : (painted_word == 1 ? value.y : value.z);
            real after = painted_nearer(before, dab_target_m.x, weight, real(1));
            if (after == before) continue;
            if (painted_word == 0) value.x = after;
            if (painted_word == 1) value.y = after;
            if (painted_word == 2) value.z = after;
            imageStore(painted, at, value);
#endif
            changed = true;
        }
    }
    if (changed) stamp_tile(tile.y * tiles.x + tile.x, tile_painted);
}

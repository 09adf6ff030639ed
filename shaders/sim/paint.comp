// One dab of paint on a rectangle of tiles: a group per tile, an invocation per column.
layout(local_size_x = 64) in;
#include "maths/glsl_types.glsl"

layout(binding = 0, rgba32f) uniform image2D painted;
#include "sim/tile_stamps.glsl"

uniform int2 samples;
uniform int2 tiles;
uniform real dab_blend;
uniform real dab_target;
uniform int painted_layer;  // component

real painted_mask(int2 at) { return imageLoad(painted, at).y; }
#include "sim/dab.glsl"
#include "maths/brush_weight.glsl"

void main() {
    int2 tile = first_tile + int2(gl_WorkGroupID.xy);
    int2 first = tile * 64 + int2(int(gl_LocalInvocationIndex), 0);
    bool changed = false;
    if (first.x < samples.x) {
        for (int row = 0; row < min(64, samples.y - first.y); ++row) {
            int2 at = first + int2(0, row);
            real4 value = imageLoad(painted, at);
            real before = painted_layer == 0 ? value.x : (painted_layer == 1 ? value.y : value.z);
            precise real way = (brush_weight_at(at) * dab_blend) * (dab_target - before);
            precise real nearer = before + way;
            // It gets there: a trace of rain that nobody sees would keep its tile awake.
            bool there = abs(dab_target - nearer) <= real(1e-3) * max(dab_target, real(1)) && way != real(0);
            real after = there ? dab_target : nearer;
            if (after == before) continue;
            if (painted_layer == 0) value.x = after;
            if (painted_layer == 1) value.y = after;
            if (painted_layer == 2) value.z = after;
            imageStore(painted, at, value);
            changed = true;
        }
    }
    if (changed) stamp_tile(tile.y * tiles.x + tile.x, tile_painted);
}

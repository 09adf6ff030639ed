// One dab of paint on a rectangle of tiles: a group per tile, an invocation per column.
layout(local_size_x = 64) in;
#include "sim/tile_samples.glsl"
#include "maths/glsl_types.glsl"
#include "sim/painted_layers.glsl"

layout(rgba32f) uniform image2D painted;
#include "sim/tile_stamps.glsl"

uniform int2 samples;
uniform int2 tiles;
uniform int painted_layer;  // component

real painted_mask(int2 at) { return imageLoad(painted, at).y; }
#include "sim/dab.glsl"
#include "maths/brush_weight.glsl"

void main() {
    int2 tile = first_tile + int2(gl_WorkGroupID.xy);
    int2 first = tile * tile_samples + int2(int(gl_LocalInvocationIndex), 0);
    bool changed = false;
    if (first.x < samples.x) {
        for (int row = 0; row < min(tile_samples, samples.y - first.y); ++row) {
            int2 at = first + int2(0, row);
            real4 value = imageLoad(painted, at);
            real before = painted_layer == layer_hardness ? value.x : (painted_layer == layer_mask ? value.y : value.z);
            precise real way = (brush_weight_at(at) * dab_blend) * (dab_target_m.x - before);
            precise real nearer = before + way;
            // It gets there: a trace of rain that nobody sees would keep its tile awake.
            bool there = abs(dab_target_m.x - nearer) <= real(1e-3) * max(dab_target_m.x, real(1)) && way != real(0);
            real after = there ? dab_target_m.x : nearer;
            if (after == before) continue;
            if (painted_layer == layer_hardness) value.x = after;
            if (painted_layer == layer_mask) value.y = after;
            if (painted_layer == layer_rain) value.z = after;
            imageStore(painted, at, value);
            changed = true;
        }
    }
    if (changed) stamp_tile(tile.y * tiles.x + tile.x, tile_painted);
}

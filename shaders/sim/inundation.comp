// The largest depth so far and when water arrived, on the listed tiles: a group for each strip of a tile.
layout(local_size_x = 64) in;
#include "sim/tile_samples.glsl"
#include "maths/glsl_types.glsl"

#include "sim/water_layout.glsl"
layout(rgba32f) uniform readonly image2D water;
layout(rg32f) uniform image2D inundation;  // m, s
#include "sim/tile_stamps.glsl"
layout(std430) readonly buffer TileList { uint list_arguments[4]; uint listed_tiles[]; };

uniform int2 samples;
uniform int2 tiles;
uniform real now_s;

void main() {
    int tile = int(listed_tiles[gl_WorkGroupID.y]);
    int2 first = int2(tile % tiles.x, tile / tiles.x) * tile_samples + int2(int(gl_LocalInvocationIndex), int(gl_WorkGroupID.x) * strip_rows);
    if (first.x >= samples.x) return;
    bool changed = false;
    for (int row = 0; row < min(strip_rows, samples.y - first.y); ++row) {
        int2 at = first + int2(0, row);
        real depth = imageLoad(water, at + water_ghosts).x;
        real2 before = imageLoad(inundation, at).xy;
        if (depth <= before.x || depth < wet_depth_m) continue;
        imageStore(inundation, at, real4(depth, before.x > real(0) ? before.y : now_s, 0.0, 0.0));
        changed = true;
    }
    if (changed) stamp_tile(tile, tile_inundation);
}

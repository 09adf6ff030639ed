// The level that rays are cast onto, over the listed tiles, a group a tile (render/water_surface.h).
layout(local_size_x = 64) in;
#include "maths/glsl_types.glsl"

layout(binding = 0, rgba32f) uniform readonly image2D water_in;  // with ghost samples beyond the edges
layout(binding = 1, r32f) uniform readonly image2D ground_in;
layout(binding = 2, r32f) uniform writeonly image2D level_out;
layout(binding = 1, std430) readonly buffer TileList { uint list_arguments[4]; uint listed_tiles[]; };

uniform int2 samples;
uniform int2 tiles;

const int water_ghosts = 2;
// Thinner water is no surface to see, m: wet ground.
const real seen_depth_m = real(0.01);
// How far below the ground the surface lies where no water is near, m: no ray looks for it there.
const real far_below_m = real(1e4);

// The highest level of seen water in a row, at a column and its two neighbours; far below where there is none.
real highest_in(int column, int row) {
    real highest = real(-1e30);
    for (int i = -1; i <= 1; ++i) {
        int2 at = clamp(int2(column + i, row), int2(0), samples - 1);
        real depth = imageLoad(water_in, at + water_ghosts).x;
        real level = imageLoad(ground_in, at).x + depth;
        highest = max(highest, depth >= seen_depth_m ? level : real(-1e30));
    }
    return highest;
}

void main() {
    int tile = int(listed_tiles[gl_WorkGroupID.y]);
    int2 first = int2(tile % tiles.x, tile / tiles.x) * 64 + int2(int(gl_LocalInvocationIndex), 0);
    if (first.x >= samples.x) return;
    // The rows before, at and after the sample, so that each is looked at once.
    real north = highest_in(first.x, first.y - 1);
    real here = highest_in(first.x, first.y);
    for (int row = 0; row < min(64, samples.y - first.y); ++row) {
        int2 at = first + int2(0, row);
        real south = highest_in(at.x, at.y + 1);
        real ground = imageLoad(ground_in, at).x;
        real depth = imageLoad(water_in, at + water_ghosts).x;
        // On dry ground the highest water beside it, but never above the ground.
        real beside = max(ground - far_below_m, max(max(north, here), south));
        imageStore(level_out, at, vec4(depth < seen_depth_m ? min(beside, ground) : ground + depth));
        north = here;
        here = south;
    }
}

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

void main() {
    int tile = int(listed_tiles[gl_WorkGroupID.y]);
    int2 first = int2(tile % tiles.x, tile / tiles.x) * 64 + int2(int(gl_LocalInvocationIndex), 0);
    if (first.x >= samples.x) return;
    for (int row = 0; row < min(64, samples.y - first.y); ++row) {
        int2 at = first + int2(0, row);
        real ground = imageLoad(ground_in, at).x;
        real depth = imageLoad(water_in, at + water_ghosts).x;
        real level = ground + depth;
        if (depth < seen_depth_m) {
            // The highest water beside it, but never above the ground.
            real beside = ground - far_below_m;
            for (int i = 0; i < 9; ++i) {
                int2 neighbour = clamp(at + int2(i % 3, i / 3) - 1, int2(0), samples - 1);
                real depth_there = imageLoad(water_in, neighbour + water_ghosts).x;
                if (depth_there >= seen_depth_m) beside = max(beside, imageLoad(ground_in, neighbour).x + depth_there);
            }
            level = min(beside, ground);
        }
        imageStore(level_out, at, vec4(level));
    }
}

// Lists the tiles that have work: those with the flag bit set in themselves or in a neighbour from `reach_low` to
// `reach_high`. The list starts with the arguments of an indirect dispatch: `groups_per_tile` x tiles x 1.
layout(local_size_x = 64) in;
#include "maths/glsl_types.glsl"

layout(binding = 0, std430) readonly buffer TileFlags { uint tile_flags[]; };
layout(binding = 1, std430) buffer TileList { uint list_arguments[4]; uint listed_tiles[]; };

uniform int2 tiles;
uniform uint flag_bit;
uniform int reach_low;
uniform int reach_high;

void main() {
    int index = int(gl_GlobalInvocationID.x);
    if (index >= tiles.x * tiles.y) return;
    int2 tile = int2(index % tiles.x, index / tiles.x);
    bool work = false;
    for (int dy = reach_low; dy <= reach_high; ++dy)
        for (int dx = reach_low; dx <= reach_high; ++dx) {
            int2 at = tile + int2(dx, dy);
            if (at.x >= 0 && at.y >= 0 && at.x < tiles.x && at.y < tiles.y)
                work = work || (tile_flags[at.y * tiles.x + at.x] & flag_bit) != 0u;
        }
    if (work) listed_tiles[atomicAdd(list_arguments[1], 1u)] = uint(index);
}

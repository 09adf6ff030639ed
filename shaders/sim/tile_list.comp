// Lists the tiles in which something changed since a number was read, or in a neighbour from `reach_low` to `reach_high`. The
// list starts with the arguments of an indirect dispatch: `groups_per_tile` x tiles x 1. One group does it all, because a dispatch
// costs more than this work.
layout(local_size_x = 256) in;
#include "maths/glsl_types.glsl"

#include "sim/tile_changes.glsl"

layout(std430) readonly buffer TileStamps { uint tile_stamps[]; };
layout(std430) buffer TileList { uint list_arguments[4]; uint listed_tiles[]; };

uniform int2 tiles;
uniform uint changes;  // a bit for each kind that is of interest
uniform uint since;
uniform int reach_low;
uniform int reach_high;
uniform uint groups_per_tile;

shared uint listed;

bool is_marked(int2 tile) {
    if (any(lessThan(tile, int2(0))) || any(greaterThanEqual(tile, tiles))) return false;
    uint first = uint(tile.y * tiles.x + tile.x) * tile_kinds;
    if (tile_stamps[first + tile_any] <= since) return false;
    for (uint kind = 0u; kind < tile_any; ++kind)
        if ((changes >> kind & 1u) != 0u && tile_stamps[first + kind] > since) return true;
    return false;
}

void main() {
    int me = int(gl_LocalInvocationIndex);
    if (me == 0) listed = 0u;
    barrier();
    int count = tiles.x * tiles.y;
    for (int index = me; index < count; index += 256) {
        int2 tile = int2(index % tiles.x, index / tiles.x);
        bool work = false;
        for (int dy = reach_low; dy <= reach_high; ++dy)
            for (int dx = reach_low; dx <= reach_high; ++dx) work = work || is_marked(tile + int2(dx, dy));
        if (work) listed_tiles[atomicAdd(listed, 1u)] = uint(index);
    }
    barrier();
    if (me == 0) {
        list_arguments[0] = groups_per_tile;
        list_arguments[1] = listed;
        list_arguments[2] = 1u;
    }
}

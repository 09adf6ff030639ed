// Decides for each level, a group each, how the listed tiles come into its ring: tile by tile, or the whole ring where that is less
// work. Near the terrain's edge a tile may be much of a coarse ring.
layout(local_size_x = 64) in;
#include "render/clipmap_changed.glsl"

layout(std430) readonly buffer TileList { uint list_arguments[4]; uint listed_tiles[]; };
layout(std430) writeonly buffer RingUpdates { uint update_arguments[]; };  // eight words a level: dispatches by tiles, of the ring

shared int samples[64];

void main() {
    int level = int(gl_WorkGroupID.x);
    int me = int(gl_LocalInvocationIndex);
    int number = int(list_arguments[1]);
    int enough = side * side;
    int mine = 0;
    for (int i = me; i < number && mine <= enough; i += 64) {
        RingPart part = part_of_tile(int(listed_tiles[i]), level);
        int2 size = max(part.last - part.first + 1, int2(0));
        mine += size.x * size.y;
    }
    // No more than is needed for the answer: the sum of all stays a whole number.
    samples[me] = min(mine, enough);
    barrier();
    if (me > 0) return;
    int all = 0;
    for (int i = 0; i < 64; ++i) all += samples[i];
    bool whole = all >= enough;
    update_arguments[8 * level] = 1u;
    update_arguments[8 * level + 1] = whole ? 0u : uint(number);
    update_arguments[8 * level + 2] = 1u;
    update_arguments[8 * level + 3] = 0u;
    update_arguments[8 * level + 4] = whole ? uint((enough + 255) / 256) : 0u;
    update_arguments[8 * level + 5] = 1u;
    update_arguments[8 * level + 6] = 1u;
    update_arguments[8 * level + 7] = 0u;
}

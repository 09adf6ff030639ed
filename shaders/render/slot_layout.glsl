// Where a slot of the pool of tiles (render/tiled/tile_pool.h) lies in its images: heights, and a pyramid of highest samples,
// level 1 on top and the coarser ones side by side below it.
#include "maths/glsl_types.glsl"

uniform int slots_in_row;
uniform int2 room_patches;  // that a slot holds; a multiple of 2 to the power of slot_top_level
uniform int slot_top_level;

// The texel of the first patch's first sample; one sample lies before it.
int2 slot_heights_corner(int slot) { return int2(slot % slots_in_row, slot / slots_in_row) * (room_patches + 2) + 1; }

int2 slot_tops_texel(int slot, int2 cell, int level) {
    int2 level_1 = room_patches / 2;
    int2 corner = int2(slot % slots_in_row, slot / slots_in_row) * int2(level_1.x, level_1.y + level_1.y / 2);
    return corner + int2(cell.x + level_1.x - ((2 * level_1.x) >> (level - 1)) + (level == 1 ? level_1.x : 0), cell.y + (level > 1 ? level_1.y : 0));
}

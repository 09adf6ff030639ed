// Where a slot of the pool of tiles (render/tiled/tile_pool.h) lies in its images: heights, and a pyramid of highest samples,
// level 1 on top, levels 2 to 4 side by side below it, and the coarser ones side by side below level 3.
#include "maths/glsl_types.glsl"

uniform int2 room_patches;   // that a slot holds; a multiple of 16
uniform int slot_top_level;  // one cell holds them all

// Slots are told by their column and row: software divides whole numbers one by one.
// The texel of the first patch's first sample; one sample lies before it.
int2 slot_heights_corner(int2 slot) { return slot * (room_patches + 2) + 1; }

// Cells of a level in a row and in a column; those at the end may reach beyond the slot's patches.
int2 slot_level_size(int level) { return (room_patches + (1 << level) - 1) >> level; }

int2 slot_tops_texel(int2 slot, int2 cell, int level) {
    int2 level_1 = room_patches / 2;
    int2 corner = slot * int2(level_1.x, level_1.y + level_1.y / 2);
    // Rows of levels 2 and up; a row of powers of two is longer than the cells of any level from 5 on.
    int halves = level < 5 ? 2 * level_1.x : 1 << slot_top_level;
    int before = level < 5 ? level_1.x : level_1.x / 2 + (halves >> 4);
    int below = level < 5 ? level_1.y : level_1.y + level_1.y / 4;
    return corner + cell + (level == 1 ? int2(0, 0) : int2(before - (halves >> (level - 1)), below));
}

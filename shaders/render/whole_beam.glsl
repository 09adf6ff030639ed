// What beams look at where the terrain is held as a whole: blocks of the pyramid over it. tile_beam.glsl gives the same of a
// terrain in tiles.
#include "render/surface.glsl"
uniform sampler2D bottoms;

// The point where four texels meet, so that one gather reads all four.
vec2 block_place(int2 cell, int level) { return vec2(pyramid_texel(cell, level) + 1) / vec2(whole_texel() + 1); }
real4 load_block_tops(int2 cell, int level) {
    return (textureGather(tops, block_place(cell, level)).wzxy - origin_height_m.x) - origin_height_m.y;
}
real4 load_block_bottoms(int2 cell, int level) {
    return (textureGather(bottoms, block_place(cell, level)).wzxy - origin_height_m.x) - origin_height_m.y;
}

// Heights of a block's cells, row by row, far below beside the terrain.
real4 block_heights(real4 heights_m, int2 cell, int level) {
    bool left = cell.x >= 0 && (cell.x << level) < patches.x;
    bool right = cell.x >= -1 && ((cell.x + 1) << level) < patches.x;
    bool first = cell.y >= 0 && (cell.y << level) < patches.y;
    bool second = cell.y >= -1 && ((cell.y + 1) << level) < patches.y;
    return real4(left && first ? heights_m.x : real(-1e30), right && first ? heights_m.y : real(-1e30),
                 left && second ? heights_m.z : real(-1e30), right && second ? heights_m.w : real(-1e30));
}

// What rays are to know of where their beam stopped, below 1.
float beam_note(real depth, real3 middle) { return 0.0; }

// What maths/beam.glsl needs.
real block_top(int2 cell, int level) {
    real4 top = block_heights(load_block_tops(cell, level), cell, level);
    return max(max(top.x, top.y), max(top.z, top.w));
}
real block_bottom(int2 cell, int level) {
    real4 bottom = block_heights(load_block_bottoms(cell, level), cell, level);
    return min(min(bottom.x, bottom.y), min(bottom.z, bottom.w));
}

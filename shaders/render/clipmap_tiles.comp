// Lists the tiles of the rings that the view may show: 16 in a row and a column of the finest level that is drawn, and those around
// the finer level of the others. Tiles that would not fit overlap their neighbours.
layout(local_size_x = 64) in;
#include "render/surface.glsl"
#include "render/camera.glsl"
#include "render/cell_box.glsl"
#include "render/clipmap_rings.glsl"
#include "render/clipmap_tile.glsl"
#include "maths/patch.glsl"

layout(std430) buffer RingTiles { uint draw_arguments[8]; uint ring_tiles[]; };

// Levels whose extent is small before the eye's height over the ground are not drawn (Asirvatham & Hoppe 2005).
int finest_level() {
    int2 cell = min(max(origin_cell, int2(0)), patches - 1);
    real2 within = min(max(real2(origin_cell - cell) + origin_fraction, real2(0.0)), real2(1.0));
    real height_m = -patch_height(load_corners(cell), within);
    real extent_m = real(side - 1) * min(cell_m.x, cell_m.y);
    int level = 0;
    while (level + 1 < levels && extent_m < 2.5 * height_m) {
        extent_m *= 2.0;
        ++level;
    }
    return level;
}

// The i-th of the tiles around the hole; negative: there are no more. `wide`: patches in a row of a ring, `hole`: its first patch,
// `hole_wide`: patches in a row of it.
int2 ring_tile(int i, int wide, int2 hole, int hole_wide) {
    int k = tile_patches();
    int2 end = hole + hole_wide;
    if (i < 64) return int2(min(k * (i % 16), wide - k), min(k * (i / 16), hole.y - k));
    i -= 64;
    if (i < 64) return int2(min(k * (i % 16), wide - k), min(end.y + k * (i / 16), wide - k));
    i -= 64;
    int row = min(hole.y + k * (i / 4 % 8), end.y - k);
    if (i < 32) return int2(min(k * (i % 4), hole.x - k), row);
    i -= 32;
    return i < 32 ? int2(min(end.x + k * (i % 4), wide - k), row) : int2(-1);
}

bool may_be_seen(int2 tile, int level) {
    int2 first = (ring_origins[level] + tile) * (1 << level);
    int2 last = first + tile_patches() * (1 << level);
    if (any(lessThan(last, int2(0))) || any(greaterThan(first, sides_from()))) return false;
    real lowest_m = (texelFetch(bottoms, whole_texel(), 0).r - origin_height_m.x) - origin_height_m.y;
    // The terrain's sides have no end.
    if (any(lessThan(first, int2(0))) || any(greaterThan(last, patches))) lowest_m = -1e9;
    return box_in_view(box_over(min(max(first, int2(0)), patches), min(max(last, int2(0)), patches), real2(lowest_m, load_highest())));
}

void main() {
    int level = int(gl_GlobalInvocationID.x) / 256;
    int i = int(gl_GlobalInvocationID.x) % 256;
    int finest = finest_level();
    if (level < finest || level >= levels) return;
    int wide = side - 1;
    int k = tile_patches();
    int2 tile = int2(min(k * (i % 16), wide - k), min(k * (i / 16), wide - k));
    if (level > finest) tile = ring_tile(i, wide, (ring_origins[level - 1] >> 1) - ring_origins[level], wide / 2);
    if (tile.x < 0 || !may_be_seen(tile, level)) return;
    ring_tiles[atomicAdd(draw_arguments[1], 1u)] = pack_tile(tile, level);
}

// A tiled terrain as shaders of render read it (render/tiled/tiled_surface.h): the tree of tiles, the pool that holds their
// samples, and where the eye is in each of them.
#include "render/slot_layout.glsl"
#include "maths/tile_place.glsl"
#include "render/tile_nodes.glsl"

uniform sampler2D tile_heights;
uniform sampler2D tile_tops;
uniform sampler2D tile_nodes;   // highest point, slot (maths/tile_cast.glsl); levels one below the other
uniform sampler2D tile_places;  // a row a slot: the eye's patch and where in it; samples for one of the finest level, level, the slot's column and 4096 times its row;
                                // the first and the last patch between its samples

uniform int tile_side_level;
uniform int tile_top_level;
uniform int tile_rows;  // of tiles of the finest level
uniform real tile_highest_m;
uniform int2 patches;
uniform real2 cell_m;
uniform int2 origin_cell;       // the eye's patch (column, row) of the finest level, and where in it
uniform real2 origin_fraction;
uniform real2 origin_height_m;  // the eye's height, two words

// Benchmarks leave a part of the caster out, to measure what it saves: the pyramid above its finest level, or ending a
// ray at its first hit.
#ifdef FINEST_LEVEL
const int slot_walk_level = 1;
#else
#define slot_walk_level slot_top_level
#endif
#ifdef EVERY_TILE
const bool cast_once = false;
#else
const bool cast_once = true;
#endif

int2 tile_slot = int2(0, 0);  // column and row of the one that was loaded last

#ifdef FROM_ELSEWHERE
// Where rays start: columns and rows of the finest level from the eye.
real2 tile_start = real2(0.0, 0.0);
#endif

real2 load_tile_node(int2 tile, int level) {
    real2 node = texelFetch(tile_nodes, tile_node_texel(tile, level, tile_rows), 0).rg;
    return real2((node.x - origin_height_m.x) - origin_height_m.y, node.y);
}

real load_highest() { return (tile_highest_m - origin_height_m.x) - origin_height_m.y; }

real load_top(int2 cell, int level) {
    return (texelFetch(tile_tops, slot_tops_texel(tile_slot, cell, level), 0).r - origin_height_m.x) - origin_height_m.y;
}

real4 load_corners(int2 at) {
    int2 last = slot_heights_corner(tile_slot) + at + 1;
    real4 z = textureGather(tile_heights, vec2(last) / vec2(textureSize(tile_heights, 0))).wzxy;
    return (z - origin_height_m.x) - origin_height_m.y;
}
TilePlace load_tile(int slot) {
    vec4 eye = texelFetch(tile_places, ivec2(0, slot), 0);
    vec4 level = texelFetch(tile_places, ivec2(1, slot), 0);
    int in_pool = int(level.w);
    tile_slot = int2(in_pool & 4095, in_pool >> 12);
    int2 cell = int2(eye.xy);
    real2 fraction = eye.zw;
#ifdef FROM_ELSEWHERE
    fraction += tile_start * level.xy;
    real2 whole = floor(fraction);
    cell += int2(whole);
    fraction -= whole;
#endif
    return TilePlace(cell, fraction, level.xy, int(level.z));
}
// The first and the last patch between samples of a slot's level that it holds.
ivec4 tile_patches(int slot) { return ivec4(texelFetch(tile_places, ivec2(2, slot), 0)); }

// The samples of a level's ring that hang on a tile of the terrain, first and last; none: the first lies beyond the last.
#include "render/height_levels.glsl"
#include "render/clipmap_rings.glsl"
#include "sim/tile_samples.glsl"

uniform int2 tiles;

struct RingPart {
    int2 first;
    int2 last;
};

RingPart part_of_tile(int tile, int level) {
    int2 first = int2(tile % tiles.x, tile / tiles.x) * tile_samples;
    int2 last = first + tile_samples - 1;
    int reach = 4 << level;  // of the coarser level's filter, and of the triangle that it is a corner of
    int2 ring_first = ring_origins[level];
    int2 ring_last = ring_first + side - 1;
    // Beyond the terrain's edge the edge goes on.
    int2 low = int2(first.x == 0 ? ring_first.x : (first.x - reach) >> level, first.y == 0 ? ring_first.y : (first.y - reach) >> level);
    int2 high = int2(last.x + reach >= patches.x ? ring_last.x : (last.x + reach) >> level,
                     last.y + reach >= patches.y ? ring_last.y : (last.y + reach) >> level);
    return RingPart(max(low, ring_first), min(high, ring_last));
}

// Writes heights into a ring: each sample's own, and the one that the coarser level's triangles have there. Of a rectangle that came
// into the ring as the eye moved, or with TILES of what changed in the listed tiles, one group a tile.
layout(local_size_x = 64) in;
#include "render/clipmap_changed.glsl"

uniform sampler2D ground;
uniform sampler2D height_levels;
layout(rg32f) uniform writeonly image2D rings;

uniform int level;
uniform int2 offset;          // of the level in the image of levels
uniform int2 coarser_offset;  // of the next

#ifdef TILES
layout(std430) readonly buffer TileList { uint list_arguments[4]; uint listed_tiles[]; };
#else
uniform int2 rectangle_first;
uniform int2 rectangle_size;
#endif

real own_height(int2 at) {
    int2 inside = min(max(at, int2(0)), last_of(level));
    return level == 0 ? texelFetch(ground, inside, 0).r : texelFetch(height_levels, offset + inside, 0).r;
}

real coarser_sample(int2 at) { return texelFetch(height_levels, coarser_offset + min(max(at, int2(0)), last_of(level + 1)), 0).r; }

// Where a place is between two samples of the coarser level. The last two may be nearer to each other than others.
real share_between(int at, int low, int high) { return high > low ? real(at - low) / real(high - low) : 0.0; }

// Its squares have the diagonal from north-east to south-west, as all meshes here.
real coarser_height(int2 at) {
    if (level + 1 == levels) return own_height(at);
    int2 low = at >> 1;
    int2 high = low + (at & 1);
    int2 place = place_of(at, level);
    int2 low_place = place_of(low, level + 1);
    int2 high_place = place_of(high, level + 1);
    real u = share_between(place.x, low_place.x, high_place.x);
    real v = share_between(place.y, low_place.y, high_place.y);
    real north_west = coarser_sample(low);
    if (u == 0.0 && v == 0.0) return north_west;
    real north_east = coarser_sample(int2(high.x, low.y));
    real south_west = coarser_sample(int2(low.x, high.y));
    if (u + v <= 1.0) return north_west + u * (north_east - north_west) + v * (south_west - north_west);
    real south_east = coarser_sample(high);
    return south_east + (1.0 - u) * (south_west - south_east) + (1.0 - v) * (north_east - south_east);
}

void update_rectangle(int2 first, int2 size, int me, int all) {
    for (int i = me; i < size.x * size.y; i += all) {
        int2 at = first + int2(i % size.x, i / size.x);
        imageStore(rings, ring_texel(at, level), vec4(own_height(at), coarser_height(at), 0.0, 0.0));
    }
}

void main() {
#ifdef TILES
    int tile = int(listed_tiles[gl_WorkGroupID.y]);
    RingPart part = part_of_tile(tile, level);
    if (part.first.x <= part.last.x && part.first.y <= part.last.y)
        update_rectangle(part.first, part.last - part.first + 1, int(gl_LocalInvocationIndex), 64);
#else
    update_rectangle(rectangle_first, rectangle_size, int(gl_GlobalInvocationID.x), int(gl_NumWorkGroups.x) * 64);
#endif
}

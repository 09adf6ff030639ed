// Levels above 6 over the listed tiles, each from the one below, then the bounds of the whole terrain: one group does
// it all, because a dispatch costs more than this work.
layout(local_size_x = 256) in;
#include "sim/tile_samples.glsl"
#include "render/pyramid_layout.glsl"

layout(std430) readonly buffer TileList { uint list_arguments[4]; uint listed_tiles[]; };
layout(r32f) coherent uniform image2D highest;
layout(r32f) coherent uniform image2D lowest;

uniform int2 tiles;
uniform int top_level;

shared real tops[256];
shared real bottoms[256];

void main() {
    int me = int(gl_LocalInvocationIndex);
    int count = int(list_arguments[1]);
    for (int level = tile_level + 1; level <= top_level; ++level) {
        for (int i = me; i < count; i += 256) {
            int tile = int(listed_tiles[i]);
            int2 cell = int2(tile % tiles.x, tile / tiles.x) >> (level - tile_level);
            if (!has_cell(cell, level)) continue;
            real top = uintBitsToFloat(0xff800000u);
            real bottom = uintBitsToFloat(0x7f800000u);
            for (int k = 0; k < 4; ++k) {
                int2 below = pyramid_texel(cell * 2 + int2(k & 1, k >> 1), level - 1);
                top = max(top, imageLoad(highest, below).r);
                bottom = min(bottom, imageLoad(lowest, below).r);
            }
            imageStore(highest, pyramid_texel(cell, level), vec4(top));
            imageStore(lowest, pyramid_texel(cell, level), vec4(bottom));
        }
        memoryBarrierImage();
        barrier();
    }
    int2 size = level_1_size >> (top_level - 1);
    real top = uintBitsToFloat(0xff800000u);
    real bottom = uintBitsToFloat(0x7f800000u);
    for (int i = me; i < size.x * size.y; i += 256) {
        int2 at = pyramid_texel(int2(i % size.x, i / size.x), top_level);
        top = max(top, imageLoad(highest, at).r);
        bottom = min(bottom, imageLoad(lowest, at).r);
    }
    tops[me] = top;
    bottoms[me] = bottom;
    barrier();
    if (me == 0) {
        for (int i = 1; i < 256; ++i) {
            top = max(top, tops[i]);
            bottom = min(bottom, bottoms[i]);
        }
        imageStore(highest, whole_texel(), vec4(top));
        imageStore(lowest, whole_texel(), vec4(bottom));
    }
}

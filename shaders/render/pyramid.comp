// Levels 1 to 6 of the pyramid over the listed tiles, one group a tile.
layout(local_size_x = 16, local_size_y = 16) in;
#include "render/pyramid_layout.glsl"

layout(binding = 0) uniform sampler2D ground;
layout(binding = 1, std430) readonly buffer TileList { uint list_arguments[4]; uint listed_tiles[]; };
layout(binding = 0, r32f) uniform writeonly image2D highest;
layout(binding = 1, r32f) uniform writeonly image2D lowest;

uniform int2 patches;
uniform int2 tiles;
uniform int top_level;

shared real tops[256];
shared real bottoms[256];

real sample_at(int2 at) { return texelFetch(ground, min(at, patches), 0).r; }

void store(int2 cell, int level, real top, real bottom) {
    if (level > top_level || !has_cell(cell, level)) return;
    imageStore(highest, pyramid_texel(cell, level), vec4(top));
    imageStore(lowest, pyramid_texel(cell, level), vec4(bottom));
}

void main() {
    int tile = int(listed_tiles[gl_WorkGroupID.y]);
    int2 corner = int2(tile % tiles.x, tile / tiles.x);
    int2 me = int2(gl_LocalInvocationID.xy);
    int index = int(gl_LocalInvocationIndex);
    int2 cell_2 = corner * 16 + me;
    real top = uintBitsToFloat(0xff800000u);
    real bottom = uintBitsToFloat(0x7f800000u);
    for (int i = 0; i < 4; ++i) {
        int2 cell_1 = cell_2 * 2 + int2(i & 1, i >> 1);
        int2 first = cell_1 * 2;
        real top_1 = uintBitsToFloat(0xff800000u);
        real bottom_1 = uintBitsToFloat(0x7f800000u);
        // 3 x 3 samples, those beyond the last patch do not count.
        if (first.x < patches.x && first.y < patches.y) {
            for (int k = 0; k < 9; ++k) {
                real z = sample_at(first + int2(k % 3, k / 3));
                top_1 = max(top_1, z);
                bottom_1 = min(bottom_1, z);
            }
        }
        store(cell_1, 1, top_1, bottom_1);
        top = max(top, top_1);
        bottom = min(bottom, bottom_1);
    }
    store(cell_2, 2, top, bottom);
    int level = 3;
    for (int size = 8; size >= 1; size /= 2) {
        tops[index] = top;
        bottoms[index] = bottom;
        barrier();
        if (me.x < size && me.y < size) {
            int at = me.y * 32 + me.x * 2;
            top = max(max(tops[at], tops[at + 1]), max(tops[at + 16], tops[at + 17]));
            bottom = min(min(bottoms[at], bottoms[at + 1]), min(bottoms[at + 16], bottoms[at + 17]));
            store(corner * size + me, level, top, bottom);
        }
        barrier();
        ++level;
    }
}

// Levels 1 to 6 of the pyramid over the listed tiles, one group a tile, one thread a cell of level 3.
layout(local_size_x = 8, local_size_y = 8) in;
#include "render/pyramid_layout.glsl"

uniform sampler2D ground;
layout(std430) readonly buffer TileList { uint list_arguments[4]; uint listed_tiles[]; };
layout(r32f) uniform writeonly image2D highest;
layout(r32f) uniform writeonly image2D lowest;

uniform int2 patches;
uniform int2 tiles;
uniform int top_level;

shared real tops[64];
shared real bottoms[64];

real sample_at(int2 at) { return texelFetch(ground, min(at, patches), 0).r; }

void store(int2 cell, int level, real top, real bottom) {
    if (level > top_level || !has_cell(cell, level)) return;
    imageStore(highest, pyramid_texel(cell, level), vec4(top));
    imageStore(lowest, pyramid_texel(cell, level), vec4(bottom));
}

// Over four cells of level 1 side by side: the bounds of each one's three samples in a row of nine.
struct Row {
    real4 top;
    real4 bottom;
};
Row row_at(int2 first) {
    real4 even = real4(sample_at(first), sample_at(first + int2(2, 0)), sample_at(first + int2(4, 0)), sample_at(first + int2(6, 0)));
    real4 odd = real4(sample_at(first + int2(1, 0)), sample_at(first + int2(3, 0)), sample_at(first + int2(5, 0)), sample_at(first + int2(7, 0)));
    real4 next = real4(even.yzw, sample_at(first + int2(8, 0)));
    return Row(max(max(even, odd), next), min(min(even, odd), next));
}

void main() {
    int tile = int(listed_tiles[gl_WorkGroupID.y]);
    int2 corner = int2(tile % tiles.x, tile / tiles.x);
    int2 me = int2(gl_LocalInvocationID.xy);
    int index = int(gl_LocalInvocationIndex);
    int2 cell_3 = corner * 8 + me;
    const real4 no_top = real4(uintBitsToFloat(0xff800000u));
    const real4 no_bottom = real4(uintBitsToFloat(0x7f800000u));
    // Cells of level 1 beyond the last patch hold nothing.
    ivec4 columns = ivec4(8 * cell_3.x) + ivec4(0, 2, 4, 6);
    bvec4 within = lessThan(columns, ivec4(patches.x));
    real4 tops_2 = no_top;
    real4 bottoms_2 = no_bottom;
    Row above = row_at(8 * cell_3);
    for (int y = 0; y < 4; ++y) {
        int row = 8 * cell_3.y + 2 * y;
        Row middle = row_at(int2(8 * cell_3.x, row + 1));
        Row below = row_at(int2(8 * cell_3.x, row + 2));
        bvec4 here = row < patches.y ? within : bvec4(false);
        real4 top_1 = mix(no_top, max(max(above.top, middle.top), below.top), here);
        real4 bottom_1 = mix(no_bottom, min(min(above.bottom, middle.bottom), below.bottom), here);
        above = below;
        for (int x = 0; x < 4; ++x) store(4 * cell_3 + int2(x, y), 1, top_1[x], bottom_1[x]);
        // Pairs along the row, then over two rows: first and second, or third and fourth cell of level 2.
        real2 pair_top = max(top_1.xz, top_1.yw);
        real2 pair_bottom = min(bottom_1.xz, bottom_1.yw);
        tops_2 = y < 2 ? real4(max(tops_2.xy, pair_top), tops_2.zw) : real4(tops_2.xy, max(tops_2.zw, pair_top));
        bottoms_2 = y < 2 ? real4(min(bottoms_2.xy, pair_bottom), bottoms_2.zw) : real4(bottoms_2.xy, min(bottoms_2.zw, pair_bottom));
    }
    for (int i = 0; i < 4; ++i) store(2 * cell_3 + int2(i & 1, i >> 1), 2, tops_2[i], bottoms_2[i]);
    real top = max(max(tops_2.x, tops_2.y), max(tops_2.z, tops_2.w));
    real bottom = min(min(bottoms_2.x, bottoms_2.y), min(bottoms_2.z, bottoms_2.w));
    store(cell_3, 3, top, bottom);
    int level = 4;
    for (int size = 4; size >= 1; size /= 2) {
        tops[index] = top;
        bottoms[index] = bottom;
        barrier();
        if (me.x < size && me.y < size) {
            int at = me.y * 16 + me.x * 2;
            top = max(max(tops[at], tops[at + 1]), max(tops[at + 8], tops[at + 9]));
            bottom = min(min(bottoms[at], bottoms[at + 1]), min(bottoms[at + 8], bottoms[at + 9]));
            store(corner * size + me, level, top, bottom);
        }
        barrier();
        ++level;
    }
}

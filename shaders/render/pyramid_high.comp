// A level above 6: the cell over each listed tile, from the four below it.
layout(local_size_x = 1) in;
#include "render/pyramid_layout.glsl"

layout(binding = 1, std430) readonly buffer TileList { uint list_arguments[4]; uint listed_tiles[]; };
layout(binding = 0, r32f) uniform image2D highest;
layout(binding = 1, r32f) uniform image2D lowest;

uniform int2 tiles;
uniform int level;

void main() {
    int tile = int(listed_tiles[gl_WorkGroupID.y]);
    int2 cell = int2(tile % tiles.x, tile / tiles.x) >> (level - 6);
    if (!has_cell(cell, level)) return;
    real top = uintBitsToFloat(0xff800000u);
    real bottom = uintBitsToFloat(0x7f800000u);
    for (int i = 0; i < 4; ++i) {
        int2 below = pyramid_texel(cell * 2 + int2(i & 1, i >> 1), level - 1);
        top = max(top, imageLoad(highest, below).r);
        bottom = min(bottom, imageLoad(lowest, below).r);
    }
    imageStore(highest, pyramid_texel(cell, level), vec4(top));
    imageStore(lowest, pyramid_texel(cell, level), vec4(bottom));
}

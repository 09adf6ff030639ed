// Levels 1 to 6 of the pyramid over the listed tiles, one group a tile. REDUCE is max or min, EMPTY its identity.
layout(local_size_x = 16, local_size_y = 16) in;
#include "maths/glsl_types.glsl"

layout(binding = 0) uniform sampler2D ground;
layout(binding = 1, std430) readonly buffer TileList { uint list_arguments[4]; uint listed_tiles[]; };
layout(binding = 0, r32f) uniform writeonly image2D level_1;
layout(binding = 1, r32f) uniform writeonly image2D level_2;
layout(binding = 2, r32f) uniform writeonly image2D level_3;
layout(binding = 3, r32f) uniform writeonly image2D level_4;
layout(binding = 4, r32f) uniform writeonly image2D level_5;
layout(binding = 5, r32f) uniform writeonly image2D level_6;

uniform int2 patches;
uniform int2 tiles;

shared real cells[256];

real sample_at(int2 at) { return texelFetch(ground, min(at, patches), 0).r; }

// A level-1 cell: 3 x 3 samples. Patches beyond the last do not count: their samples repeat the edge's.
real two_by_two(int2 first) {
    if (first.x >= patches.x || first.y >= patches.y) return EMPTY;
    real bound = sample_at(first);
    for (int y = 0; y <= 2; ++y)
        for (int x = 0; x <= 2; ++x) bound = REDUCE(bound, sample_at(first + int2(x, y)));
    return bound;
}

void main() {
    int tile = int(listed_tiles[gl_WorkGroupID.y]);
    int2 corner = int2(tile % tiles.x, tile / tiles.x);
    int2 me = int2(gl_LocalInvocationID.xy);
    int2 cell_2 = corner * 16 + me;
    real bound = EMPTY;
    for (int i = 0; i < 4; ++i) {
        int2 cell_1 = cell_2 * 2 + int2(i & 1, i >> 1);
        real part = two_by_two(cell_1 * 2);
        imageStore(level_1, cell_1, vec4(part));
        bound = REDUCE(bound, part);
    }
    imageStore(level_2, cell_2, vec4(bound));
    for (int size = 8; size >= 1; size /= 2) {
        cells[gl_LocalInvocationIndex] = bound;
        barrier();
        if (me.x < size && me.y < size) {
            int at = me.y * 32 + me.x * 2;
            bound = REDUCE(REDUCE(cells[at], cells[at + 1]), REDUCE(cells[at + 16], cells[at + 17]));
            int2 cell = corner * size + me;
            if (size == 8) imageStore(level_3, cell, vec4(bound));
            if (size == 4) imageStore(level_4, cell, vec4(bound));
            if (size == 2) imageStore(level_5, cell, vec4(bound));
            if (size == 1) imageStore(level_6, cell, vec4(bound));
        }
        barrier();
    }
}

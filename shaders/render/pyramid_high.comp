// A level above 6: the cell over each listed tile, from the four below it. REDUCE is max or min, EMPTY its identity.
layout(local_size_x = 1) in;
#include "maths/glsl_types.glsl"

layout(binding = 1, std430) readonly buffer TileList { uint list_arguments[4]; uint listed_tiles[]; };
layout(binding = 0, r32f) uniform readonly image2D below;
layout(binding = 1, r32f) uniform writeonly image2D above;

uniform int2 tiles;
uniform int level;

void main() {
    int tile = int(listed_tiles[gl_WorkGroupID.y]);
    int2 cell = int2(tile % tiles.x, tile / tiles.x) >> (level - 6);
    int2 at = cell * 2;
    real a = imageLoad(below, at).r;
    real b = imageLoad(below, at + int2(1, 0)).r;
    real c = imageLoad(below, at + int2(0, 1)).r;
    real d = imageLoad(below, at + int2(1, 1)).r;
    imageStore(above, cell, vec4(REDUCE(REDUCE(a, b), REDUCE(c, d))));
}

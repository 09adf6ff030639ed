// One level of heights from the finer one, where the listed tiles change it: weights 1, 2, 1 over 4 along columns and rows. One
// group a tile.
layout(local_size_x = 64) in;
#include "render/height_levels.glsl"
#include "sim/tile_samples.glsl"

layout(std430) readonly buffer TileList { uint list_arguments[4]; uint listed_tiles[]; };
uniform sampler2D ground;
layout(r32f) uniform image2D height_levels;

uniform int2 tiles;
uniform int level;
uniform int2 offset;        // of the level in the image
uniform int2 finer_offset;  // of the one below; level 0 is the ground

real finer(int2 at) {
    int2 inside = min(max(at, int2(0)), last_of(level - 1));
    return level == 1 ? texelFetch(ground, inside, 0).r : imageLoad(height_levels, finer_offset + inside).r;
}

real filtered(int2 at) {
    // The terrain's corners keep their heights, so that two levels that meet at a corner's upright edge agree.
    bvec2 at_end = bvec2(at.x == 0 || at.x == last_of(level).x, at.y == 0 || at.y == last_of(level).y);
    if (all(at_end)) return finer(2 * at);
    precise real sum = 0.0;
    for (int y = -1; y <= 1; ++y) {
        precise real row = 0.25 * (finer(2 * at + int2(-1, y)) + finer(2 * at + int2(1, y))) + 0.5 * finer(2 * at + int2(0, y));
        sum += (y == 0 ? 0.5 : 0.25) * row;
    }
    return sum;
}

void main() {
    int tile = int(listed_tiles[gl_WorkGroupID.y]);
    int2 first = int2(tile % tiles.x, tile / tiles.x) * tile_samples;
    // A sample hangs on those of the terrain that are nearer than 2^level.
    int spacing = 1 << level;
    int2 low = (first + 1) >> level;
    int2 high = min((min(first + tile_samples - 1, patches) + 2 * spacing - 2) >> level, last_of(level));
    // The last column lies nearer to the one before.
    high = int2(first.x + tile_samples > patches.x ? last_of(level).x : high.x, first.y + tile_samples > patches.y ? last_of(level).y : high.y);
    low = max(low - 1, int2(0));
    int2 size = high - low + 1;
    for (int i = int(gl_LocalInvocationIndex); i < size.x * size.y; i += 64) {
        int2 at = low + int2(i % size.x, i / size.x);
        imageStore(height_levels, offset + at, vec4(filtered(at)));
    }
}

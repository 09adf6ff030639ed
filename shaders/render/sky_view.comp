// The share of the sky that squares of 4 x 4 patches see, over the listed tiles, one group a tile (render/sky_view.h).
layout(local_size_x = 16, local_size_y = 16) in;
#include "render/pyramid_layout.glsl"

uniform sampler2D tops;
uniform sampler2D bottoms;
layout(std430) readonly buffer TileList { uint list_arguments[4]; uint listed_tiles[]; };
layout(r32f) uniform writeonly image2D share;

uniform int2 tiles;
uniform int2 squares;
uniform int2 patches;
uniform int top_level;
uniform real2 cell_m;

// The middle of a cell's bounds: smoother from cell to cell than its top.
real middle_of(int2 cell, int level) {
    int2 texel = pyramid_texel(cell, level);
    return 0.5 * (texelFetch(tops, texel, 0).r + texelFetch(bottoms, texel, 0).r);
}

void main() {
    int tile = int(listed_tiles[gl_WorkGroupID.y]);
    int2 square = int2(tile % tiles.x, tile / tiles.x) * 16 + int2(gl_LocalInvocationID.xy);
    if (any(greaterThanEqual(square, squares))) return;
    int2 first = square * 4;
    if (any(greaterThanEqual(first, patches))) {
        imageStore(share, square, vec4(1.0));
        return;
    }
    int own_level = min(2, top_level);
    real height_m = middle_of(first >> own_level, own_level);
    real seen = 0.0;
    for (int direction = 0; direction < 8; ++direction) {
        real angle = 0.785398163 * real(direction);
        real2 along = real2(cos(angle), sin(angle));
        // The slope up to the steepest: no cell ends farther than 40 + 16 samples away.
        real steepest = 0.0;
        for (int k = 0; k < 4; ++k) {
            int level = min(k < 2 ? 2 : k + 1, top_level);
            real samples = k == 0 ? 5.0 : k == 1 ? 10.0 : k == 2 ? 20.0 : 40.0;
            int2 at = first + 2 + int2(floor(samples * along + 0.5));
            if (any(lessThan(at, int2(0))) || any(greaterThanEqual(at, patches))) continue;
            int2 cell = at >> level;
            // From middle to middle, so that a cell's size does not matter.
            real2 offset = (real2(cell << level) + 0.5 * real(1 << level) - real2(first) - 2.0) * cell_m;
            steepest = max(steepest, (middle_of(cell, level) - height_m) / max(length(offset), cell_m.x));
        }
        // The share of a sky of even light over a horizon that high: 1 - sin^2 of its angle.
        seen += 1.0 / (1.0 + steepest * steepest);
    }
    imageStore(share, square, vec4(seen / 8.0));
}

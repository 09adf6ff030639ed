// Sums of a tile in double: metres of solid now, of ground moved from where it was at the start, and of water.
layout(local_size_x = 64) in;
#include "maths/glsl_types.glsl"

layout(binding = 0, rgba32f) uniform readonly image2D solid_in;
layout(binding = 1, rg32f) uniform readonly image2D start_in;   // ground at the start, two words
#ifdef WATER
layout(binding = 2, rgba32f) uniform readonly image2D water_in;
const int water_ghosts = 2;
#endif
layout(binding = 0, std430) writeonly buffer TileSums { dvec4 tile_sums[]; };  // solid, |ground - start|, water

uniform int2 samples;
uniform int2 tiles;

shared dvec3 column_sums[64];

void main() {
    int2 tile = int2(gl_WorkGroupID.xy);
    int column = tile.x * 64 + int(gl_LocalInvocationIndex);
    dvec3 sum = dvec3(0.0);
    if (column < samples.x) {
        for (int row = tile.y * 64; row < min(tile.y * 64 + 64, samples.y); ++row) {
            int2 at = int2(column, row);
            dvec4 words = dvec4(imageLoad(solid_in, at));
            dvec2 start = dvec2(imageLoad(start_in, at).xy);
            double solid = (words.x + words.z) + (words.y + words.w);
            sum += dvec3(solid, abs(solid - (start.x + start.y)), 0.0);
#ifdef WATER
            dvec2 depth = dvec2(imageLoad(water_in, at + water_ghosts).xy);
            sum.z += depth.x + depth.y;
#endif
        }
    }
    column_sums[gl_LocalInvocationIndex] = sum;
    barrier();
    if (gl_LocalInvocationIndex == 0u) {
        dvec3 total = dvec3(0.0);
        for (int i = 0; i < 64; ++i) total += column_sums[i];
        tile_sums[tile.y * tiles.x + tile.x] = dvec4(total, 0.0);
    }
}

// Sums of a tile in double, metres: of bedrock, regolith, suspended solid and water, and of ground that is lower and higher
// than at the start.
layout(local_size_x = 64) in;
#include "sim/tile_samples.glsl"
#include "maths/glsl_types.glsl"

layout(rgba32f) uniform readonly image2D solid_in;
layout(rg32f) uniform readonly image2D start_in;   // ground at the start, two words
#include "sim/water_layout.glsl"
#ifdef WATER
layout(rgba32f) uniform readonly image2D water_in;
#endif
#ifdef SEDIMENT
layout(rg32f) uniform readonly image2D load_in;
#endif
layout(std430) writeonly buffer TileSums { dvec4 tile_sums[]; };  // stores, changes; two a tile

uniform int2 samples;
uniform int2 tiles;

shared dvec4 column_stores[tile_samples];
shared dvec2 column_changes[tile_samples];

void main() {
    int2 tile = int2(gl_WorkGroupID.xy);
    int column = tile.x * tile_samples + int(gl_LocalInvocationIndex);
    dvec4 stores = dvec4(0.0);
    dvec2 changes = dvec2(0.0);
    if (column < samples.x) {
        for (int row = tile.y * tile_samples; row < min(tile.y * tile_samples + tile_samples, samples.y); ++row) {
            int2 at = int2(column, row);
            dvec4 words = dvec4(imageLoad(solid_in, at));
            dvec2 start = dvec2(imageLoad(start_in, at).xy);
            double gain = ((words.x + words.z) + (words.y + words.w)) - (start.x + start.y);
            stores.xy += dvec2(words.x + words.y, words.z + words.w);
            changes += dvec2(max(-gain, 0.0lf), max(gain, 0.0lf));
#ifdef SEDIMENT
            dvec2 load = dvec2(imageLoad(load_in, at + water_ghosts).xy);
            stores.z += load.x + load.y;
#endif
#ifdef WATER
            dvec2 depth = dvec2(imageLoad(water_in, at + water_ghosts).xy);
            stores.w += depth.x + depth.y;
#endif
        }
    }
    column_stores[gl_LocalInvocationIndex] = stores;
    column_changes[gl_LocalInvocationIndex] = changes;
    barrier();
    if (gl_LocalInvocationIndex == 0u) {
        stores = dvec4(0.0);
        changes = dvec2(0.0);
        for (int i = 0; i < tile_samples; ++i) {
            stores += column_stores[i];
            changes += column_changes[i];
        }
        int index = 2 * (tile.y * tiles.x + tile.x);
        tile_sums[index] = stores;
        tile_sums[index + 1] = dvec4(changes, 0.0, 0.0);
    }
}

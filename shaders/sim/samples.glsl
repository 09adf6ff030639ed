// The layers as sim passes see them, front to read and back to write: bedrock high, low, regolith high, low in one
// texel; and the ground that follows.
#include "maths/glsl_types.glsl"

layout(binding = 0, rgba32f) uniform readonly image2D solid_in;
layout(binding = 1, rgba32f) uniform writeonly image2D solid_out;
layout(binding = 2, r32f) uniform writeonly image2D ground_out;

// Per tile, since each was last cleared: 1, the surface must be refreshed; 2, it is active; 4, undo must keep it; 8, what its
// ground hides of the sky; 16, the bed of its water; 32, its water is active; 64, the
// surface of its water; 128 to 1024, its water is active beside its north, south, west, east neighbour; 2048, its inundation.
layout(binding = 0, std430) buffer TileFlags { uint tile_flags[]; };

uniform int2 samples;    // columns, rows
uniform int2 tiles;      // tiles in x and in y
const uint tile_changed = 95u;  // by a change of the ground

real4 load_solid(int2 at) { return imageLoad(solid_in, clamp(at, int2(0), samples - 1)); }

void mark_tile(int2 at) {
    uint tile = uint((at.y >> 6) * tiles.x + (at.x >> 6));
    if ((tile_flags[tile] & tile_changed) != tile_changed) atomicOr(tile_flags[tile], tile_changed);
}

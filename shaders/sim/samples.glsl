// The layers as sim passes see them, front to read and back to write: bedrock high, low, regolith high, low in one
// texel; and the ground that follows.
#include "sim/tile_samples.glsl"
#include "maths/glsl_types.glsl"

layout(rgba32f) uniform readonly image2D solid_in;
layout(rgba32f) uniform writeonly image2D solid_out;
layout(r32f) uniform writeonly image2D ground_out;

#include "sim/tile_stamps.glsl"

uniform int2 samples;    // columns, rows
uniform int2 tiles;      // tiles in x and in y

real4 load_solid(int2 at) { return imageLoad(solid_in, clamp(at, int2(0), samples - 1)); }

// By a change of its ground.
void mark_tile(int2 at) { stamp_tile(at.y / tile_samples * tiles.x + at.x / tile_samples, tile_ground); }

// The level that rays are cast onto, over the listed tiles, a group a tile (render/water_surface.h).
layout(local_size_x = 64) in;
#include "maths/glsl_types.glsl"

layout(binding = 0, rgba32f) uniform readonly image2D water_in;  // with ghost samples beyond the edges
layout(binding = 1, r32f) uniform readonly image2D ground_in;
layout(binding = 2, r32f) uniform writeonly image2D level_out;
layout(binding = 1, std430) readonly buffer TileList { uint list_arguments[4]; uint listed_tiles[]; };

uniform int2 samples;
uniform int2 tiles;

const int water_ghosts = 2;
#include "render/film.glsl"
// How far below the ground the surface lies where no water is near, m: no ray looks for it there.
const real far_below_m = real(1e4);

// From 0, a film that lies on the ground, to 1, water with a surface of its own.
real body_of(real depth) { return smoothstep(film_m.x, film_m.y, depth); }

// Levels of the water that is more than a film in a row, at a column and its two neighbours: their sum above a datum, and how
// many they are. What is little more than a film counts little, so that nothing leaps where a sample crosses that.
real2 levels_in(int column, int row, real datum) {
    real2 sum = real2(0);
    for (int i = -1; i <= 1; ++i) {
        int2 at = clamp(int2(column + i, row), int2(0), samples - 1);
        real depth = imageLoad(water_in, at + water_ghosts).x;
        real body = body_of(depth);
        sum += body * real2((imageLoad(ground_in, at).x - datum) + depth, 1.0);
    }
    return sum;
}

void main() {
    int tile = int(listed_tiles[gl_WorkGroupID.y]);
    int2 first = int2(tile % tiles.x, tile / tiles.x) * 64 + int2(int(gl_LocalInvocationIndex), 0);
    if (first.x >= samples.x) return;
    // Levels are summed above the tile's own height, which leaves them their digits.
    real datum = imageLoad(ground_in, first).x;
    // The rows before, at and after the sample, so that each is looked at once.
    real2 north = levels_in(first.x, first.y - 1, datum);
    real2 here = levels_in(first.x, first.y, datum);
    for (int row = 0; row < min(64, samples.y - first.y); ++row) {
        int2 at = first + int2(0, row);
        real2 south = levels_in(at.x, at.y + 1, datum);
        real ground = imageLoad(ground_in, at).x;
        real depth = imageLoad(water_in, at + water_ghosts).x;
        // On dry ground the mean level of the water beside it, but never above the ground, so that the waterline is where the
        // level meets the ground within the patch. The highest of them would do in a lake; where water runs, it is the one
        // upstream, which may stand above the ground here, and the waterline would go from sample to sample. From there a
        // film rises to a surface of its own.
        real2 beside = north + here + south;
        real dry = beside.y > real(0) ? min(datum + beside.x / beside.y, ground) : ground - (depth < film_m.x ? far_below_m : real(0));
        imageStore(level_out, at, vec4(mix(dry, ground + depth, body_of(depth))));
        north = here;
        here = south;
    }
}

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

// The highest level of water that is more than a film in a row, at a column and its two neighbours; far below where there
// is none.
real highest_in(int column, int row) {
    real highest = real(-1e30);
    for (int i = -1; i <= 1; ++i) {
        int2 at = clamp(int2(column + i, row), int2(0), samples - 1);
        real depth = imageLoad(water_in, at + water_ghosts).x;
        real level = imageLoad(ground_in, at).x + depth * body_of(depth);
        highest = max(highest, depth >= film_m.x ? level : real(-1e30));
    }
    return highest;
}

void main() {
    int tile = int(listed_tiles[gl_WorkGroupID.y]);
    int2 first = int2(tile % tiles.x, tile / tiles.x) * 64 + int2(int(gl_LocalInvocationIndex), 0);
    if (first.x >= samples.x) return;
    // The rows before, at and after the sample, so that each is looked at once.
    real north = highest_in(first.x, first.y - 1);
    real here = highest_in(first.x, first.y);
    for (int row = 0; row < min(64, samples.y - first.y); ++row) {
        int2 at = first + int2(0, row);
        real south = highest_in(at.x, at.y + 1);
        real ground = imageLoad(ground_in, at).x;
        real depth = imageLoad(water_in, at + water_ghosts).x;
        // On dry ground the highest water beside it, but never above the ground, so that the waterline is where the level
        // meets the ground within the patch. From there a film rises to a surface of its own.
        real beside = max(max(north, here), south);
        bool is_near = beside > ground - far_below_m;
        real dry = is_near ? min(beside, ground) : ground - (depth < film_m.x ? far_below_m : real(0));
        imageStore(level_out, at, vec4(mix(dry, ground + depth, body_of(depth))));
        north = here;
        here = south;
    }
}

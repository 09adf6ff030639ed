// The level that rays are cast onto, over the listed tiles, a group a tile (render/water_surface.h).
layout(local_size_x = 64) in;
#include "sim/tile_samples.glsl"
#include "maths/glsl_types.glsl"

layout(rgba32f) uniform readonly image2D water_in;  // with ghost samples beyond the edges
layout(r32f) uniform readonly image2D ground_in;
layout(r32f) uniform writeonly image2D level_out;
layout(std430) readonly buffer TileList { uint list_arguments[4]; uint listed_tiles[]; };

uniform int2 samples;
uniform int2 tiles;
uniform real2 cell_m;

#include "sim/water_layout.glsl"
#include "render/film.glsl"
// How far below the ground the surface lies where no water is near, m: no ray looks for it there.
const real far_below_m = real(1e4);
// Water less steep than the first has a level across it; water steeper than the second is a sheet, and has none.
const real2 steep = real2(0.15, 0.45);

// From 0, a film that lies on the ground, to 1, water with a surface of its own.
real body_of(real depth) { return smoothstep(film_m.x, film_m.y, depth); }

// Water beside a sample that is more than a film. The nearer to a film, the less it counts: in the sum by its weight, among
// the highest and lowest by an offset away from them. So nothing leaps where a sample becomes a film. Levels above a datum, m.
struct Beside {
    real sum;     // of the levels
    real weight;  // how many they are
    real highest;
    real lowest;
};

// In a row, at a column and its two neighbours.
Beside beside_in(int column, int row, real datum) {
    Beside found = Beside(real(0), real(0), real(-2) * far_below_m, real(2) * far_below_m);
    for (int i = -1; i <= 1; ++i) {
        int2 at = clamp(int2(column + i, row), int2(0), samples - 1);
        real depth = imageLoad(water_in, at + water_ghosts).x;
        real body = body_of(depth);
        real level = (imageLoad(ground_in, at).x - datum) + depth;
        found.sum += body * level;
        found.weight += body;
        real apart = body > real(0) ? (real(1) - body) * (real(4) * max(cell_m.x, cell_m.y)) : real(2) * far_below_m;
        found.highest = max(found.highest, level - apart);
        found.lowest = min(found.lowest, level + apart);
    }
    return found;
}

Beside joined(Beside a, Beside b) {
    return Beside(a.sum + b.sum, a.weight + b.weight, max(a.highest, b.highest), min(a.lowest, b.lowest));
}

// The level that is extended below dry ground: the mean of the levels beside it. The highest of them would be wrong in
// running water: it is the one upstream, may stand above the ground here, and would lead the waterline from sample to
// sample. A sheet on steep ground has no common level: there the highest counts, and the sheet ends at the dry sample.
real level_beside(Beside water) {
    real mean = water.sum / water.weight;
    real slope = (water.highest - water.lowest) / (real(2) * min(cell_m.x, cell_m.y));
    return mix(mean, max(mean, water.highest), smoothstep(steep.x, steep.y, slope));
}

void main() {
    int tile = int(listed_tiles[gl_WorkGroupID.y]);
    int2 first = int2(tile % tiles.x, tile / tiles.x) * tile_samples + int2(int(gl_LocalInvocationIndex), 0);
    if (first.x >= samples.x) return;
    // Levels are summed above the tile's own height, which leaves them their digits.
    real datum = imageLoad(ground_in, first).x;
    // The rows before, at and after the sample, so that each is looked at once.
    Beside north = beside_in(first.x, first.y - 1, datum);
    Beside here = beside_in(first.x, first.y, datum);
    for (int row = 0; row < min(tile_samples, samples.y - first.y); ++row) {
        int2 at = first + int2(0, row);
        Beside south = beside_in(at.x, at.y + 1, datum);
        real ground = imageLoad(ground_in, at).x;
        real depth = imageLoad(water_in, at + water_ghosts).x;
        // Never above the ground, so that the waterline is where the level meets the ground within the patch. From there a film
        // rises to a surface of its own.
        Beside water = joined(joined(north, here), south);
        real dry = water.weight > real(0) ? min(datum + level_beside(water), ground)
                                          : ground - (depth < film_m.x ? far_below_m : real(0));
        imageStore(level_out, at, vec4(mix(dry, ground + depth, body_of(depth))));
        north = here;
        here = south;
    }
}

// One dab on a rectangle of tiles, a group per tile, and what it added and took, booked per tile in double.
layout(local_size_x = 16, local_size_y = 16) in;
#include "sim/tile_samples.glsl"
#include "sim/samples.glsl"
#include "maths/solid.glsl"
#ifdef WEAR_MAP
#include "maths/wear.glsl"
layout(rgba32f) uniform image2D worn;
#endif

layout(std430) buffer TileBooks { dvec4 tile_books[]; };  // metres of bedrock in, out, of regolith in, out

uniform int2 dab_low;   // samples that it can change, both included
uniform int2 dab_high;
// Software runs what a branch leaves out: a program for each mode.
const int dab_mode = DAB_MODE;

#ifdef ERODED
#include "sim/water_layout.glsl"
// The window around the dab as it was eroded, and its load, which has two ghost samples around.
layout(rgba32f) uniform readonly image2D eroded;
layout(rg32f) uniform readonly image2D eroded_load;
uniform int2 first_tile;
uniform real erode_settled;  // metres of regolith that a metre of load becomes

real eroded_ground(int2 at, int2 last) { return ground_height(imageLoad(eroded, clamp(at, int2(0), last))); }

real4 after_dab(int2 at, real4 before) {
    if (any(lessThan(at, dab_low)) || any(greaterThan(at, dab_high))) return before;
    int2 there = at - dab_low;
    real4 after = imageLoad(eroded, there);
    // What settles at a stroke's end raises no sample by more than half of the way to its highest neighbour: all else
    // would stick out. What is left of the load is removed, and booked as taken by the brush.
    int2 last = dab_high - dab_low;
    real highest = max(max(eroded_ground(there + int2(-1, 0), last), eroded_ground(there + int2(1, 0), last)),
                       max(eroded_ground(there + int2(0, -1), last), eroded_ground(there + int2(0, 1), last)));
    precise real rise = max(highest - eroded_ground(there, last), real(0)) * real(0.5);
    precise real load = imageLoad(eroded_load, there + water_ghosts).x * erode_settled;
    real settled = min(load, rise);
    return settled > real(0) ? change_ground(after, settled, true) : after;
}
#else
layout(rgba32f) uniform readonly image2D painted;
layout(r32f) uniform readonly image2D stamp;
real painted_mask(int2 at) { return imageLoad(painted, at).y; }
#include "sim/dab.glsl"

#ifdef PATH
layout(std430) readonly buffer PathPoints { vec4 path_line[]; };  // metres from the dab's centre (column, row), and above its target
real3 load_path(int i) { return path_line[i].xyz; }
#else
real3 load_path(int i) { return real3(0.0); }
#endif
real load_stamp(int2 at) { return imageLoad(stamp, clamp(at, int2(0), stamp_samples - 1)).x; }
#include "maths/brush.glsl"

real4 after_dab(int2 at, real4 before) {
    real change = brush_change(at, before);
    return change != 0.0 ? brush_sample(before, change) : before;
}
#endif

// What a change brought and took, by layer: the words as they are, so that no rounding is missed.
dvec4 book_of(real4 after, real4 before) {
    double rock = (double(after.x) - double(before.x)) + (double(after.y) - double(before.y));
    double loose = (double(after.z) - double(before.z)) + (double(after.w) - double(before.w));
    return dvec4(max(rock, 0.0lf), max(-rock, 0.0lf), max(loose, 0.0lf), max(-loose, 0.0lf));
}

shared dvec4 column_books[16];
shared dvec4 sample_books[256];

void main() {
    int2 tile = first_tile + int2(gl_WorkGroupID.xy);
    const int blocks_across = tile_samples / block_samples;
    dvec4 book = dvec4(0.0);
    bool changed = false;
    for (int block = 0; block < tile_blocks; ++block) {
        int2 corner = tile * tile_samples + int2(block % blocks_across, block / blocks_across) * block_samples;
        if (any(lessThan(corner + (block_samples - 1), dab_low)) || any(greaterThan(corner, dab_high))) continue;
        int2 at = corner + int2(gl_LocalInvocationID.xy);
        if (at.x >= samples.x || at.y >= samples.y) continue;
        real4 before = load_solid(at);
        // What it leaves is written too: the other image may hold what was before.
        real4 after = after_dab(at, before);
        if (after != before) {
            imageStore(ground_out, at, vec4(ground_height(after)));
#ifdef WEAR_MAP
            imageStore(worn, at, wear_counted(imageLoad(worn, at), before, after));
#endif
            book += book_of(after, before);
            changed = true;
        }
        imageStore(solid_out, at, after);
    }
    if (changed) mark_tile(tile * tile_samples);
    sample_books[gl_LocalInvocationIndex] = book;
    barrier();
    if (gl_LocalInvocationID.y == 0u) {
        dvec4 sum = dvec4(0.0);
        for (int row = 0; row < 16; ++row) sum += sample_books[row * 16 + int(gl_LocalInvocationID.x)];
        column_books[gl_LocalInvocationID.x] = sum;
    }
    barrier();
    if (gl_LocalInvocationIndex == 0u) {
        dvec4 sum = dvec4(0.0);
        for (int column = 0; column < 16; ++column) sum += column_books[column];
        tile_books[tile.y * tiles.x + tile.x] += sum;
    }
}

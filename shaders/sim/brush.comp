// One dab on a rectangle of tiles, a group per tile, and what it added and took, booked per tile in double.
layout(local_size_x = 16, local_size_y = 16) in;
#include "sim/samples.glsl"

layout(binding = 1, std430) buffer TileBooks { dvec2 tile_books[]; };  // metres of solid in, out

uniform int2 first_tile;
uniform real2 cell_m;
uniform int2 dab_sample;
uniform real2 dab_offset;
uniform real dab_radius_m;
uniform real dab_falloff;
uniform int dab_mode;
uniform real dab_amount_m;
uniform real dab_blend;
uniform real2 dab_target_m;
uniform int dab_on_regolith;
#include "maths/brush.glsl"

shared dvec2 column_books[16];
shared dvec2 sample_books[256];

void main() {
    int2 tile = first_tile + int2(gl_WorkGroupID.xy);
    dvec2 book = dvec2(0.0);
    bool changed = false;
    for (int block = 0; block < 16; ++block) {
        int2 at = tile * 64 + int2(block & 3, block >> 2) * 16 + int2(gl_LocalInvocationID.xy);
        if (at.x >= samples.x || at.y >= samples.y) continue;
        real4 before = load_solid(at);
        real change = brush_change(at, before);
        real4 after = before;
        if (change != 0.0) {
            after = brush_sample(before, change);
            imageStore(ground_out, at, vec4(ground_height(after)));
            book += dvec2(max(double(change), 0.0lf), max(-double(change), 0.0lf));
            changed = true;
        }
        imageStore(solid_out, at, after);
    }
    if (changed) mark_tile(tile * 64);
    sample_books[gl_LocalInvocationIndex] = book;
    barrier();
    if (gl_LocalInvocationID.y == 0u) {
        dvec2 sum = dvec2(0.0);
        for (int row = 0; row < 16; ++row) sum += sample_books[row * 16 + int(gl_LocalInvocationID.x)];
        column_books[gl_LocalInvocationID.x] = sum;
    }
    barrier();
    if (gl_LocalInvocationIndex == 0u) {
        dvec2 sum = dvec2(0.0);
        for (int column = 0; column < 16; ++column) sum += column_books[column];
        tile_books[tile.y * tiles.x + tile.x] += sum;
    }
}

// One dab of water on a rectangle of tiles, a group per tile and an invocation per column, and what it added and took,
// booked per tile in double.
layout(local_size_x = 64) in;
#include "sim/tile_samples.glsl"
#include "maths/glsl_types.glsl"

#include "sim/water_layout.glsl"
layout(rgba32f) uniform image2D water;
#include "sim/tile_stamps.glsl"
layout(std430) buffer TileBooks { dvec2 tile_books[]; };  // metres of water in, out

uniform int2 samples;
uniform int2 tiles;

layout(rgba32f) uniform readonly image2D painted;
real painted_mask(int2 at) { return imageLoad(painted, at).y; }
#include "sim/dab.glsl"
#include "maths/two_sum.glsl"
#include "maths/brush_weight.glsl"
#include "maths/water_brush.glsl"

shared dvec2 column_books[tile_samples];

void main() {
    int2 tile = first_tile + int2(gl_WorkGroupID.xy);
    int2 first = tile * tile_samples + int2(int(gl_LocalInvocationIndex), 0);
    dvec2 book = dvec2(0.0);
    bool changed = false;
    if (first.x < samples.x) {
        for (int row = 0; row < min(tile_samples, samples.y - first.y); ++row) {
            int2 at = first + int2(0, row);
            real4 before = imageLoad(water, at + water_ghosts);
            real change = water_brush_change(at, before);
            if (change == real(0)) continue;
            imageStore(water, at + water_ghosts, water_brush_sample(before, change));
            book += dvec2(max(double(change), 0.0lf), max(-double(change), 0.0lf));
            changed = true;
        }
    }
    if (changed) stamp_tile(tile.y * tiles.x + tile.x, tile_placed);
    column_books[gl_LocalInvocationIndex] = book;
    barrier();
    if (gl_LocalInvocationIndex == 0u) {
        dvec2 sum = dvec2(0.0);
        for (int i = 0; i < tile_samples; ++i) sum += column_books[i];
        tile_books[tile.y * tiles.x + tile.x] += sum;
    }
}

// A sample of a tile of a ring: (k + 1)^2 vertices, row by row. Towards its outline a level goes over into the next coarser one.
#include "render/surface.glsl"
#include "render/camera.glsl"
#include "render/clipmap_rings.glsl"
#include "render/clipmap_tile.glsl"

layout(std430) readonly buffer RingTiles { uint draw_arguments[8]; uint ring_tiles[]; };
uniform sampler2D rings;
uniform real near_m;

flat out int drawn_level;

void main() {
    uint tile = ring_tiles[gl_InstanceID];
    int level = level_of(tile);
    bool has_coarser = level + 1 < levels;
    int row = tile_patches() + 1;
    int2 local = place_of_tile(tile) + int2(gl_VertexID % row, gl_VertexID / row);
    bvec2 on_outline = bvec2(local.x == 0 || local.x == side - 1, local.y == 0 || local.y == side - 1);
    // Odd ones of the outline lie on the one before, so that its edges are the coarser level's: no cracks.
    if (has_coarser && on_outline.y) local.x &= ~1;
    if (has_coarser && on_outline.x) local.y &= ~1;
    int2 at = ring_origins[level] + local;
    int2 column_row = at * (1 << level);
    bool beyond = any(lessThan(column_row, int2(0))) || any(greaterThan(column_row, sides_from()));
    real2 from_eye = abs((real2(column_row - origin_cell) - origin_fraction) / real(1 << level));
    real transition = 0.1 * real(side);
    real2 shares = (from_eye - (0.5 * real(side - 1) - transition - 1.0)) / transition;
    real coarser = has_coarser ? min(max(max(shares.x, shares.y), 0.0), 1.0) : 0.0;
    if (has_coarser && (on_outline.x || on_outline.y)) coarser = 1.0;
    real2 heights = texelFetch(rings, ring_texel(at, level), 0).rg;
    real height = coarser == 1.0 ? heights.y : heights.x + coarser * (heights.y - heights.x);
    real2 place = (real2(min(max(column_row, int2(0)), patches) - origin_cell) - origin_fraction) * cell_m;
    // Below, a point at infinity: a direction.
    real3 clip = clip_of(beyond ? real3(0.0, 0.0, -1.0) : real3(place.x, -place.y, (height - origin_height_m.x) - origin_height_m.y));
    gl_Position = vec4(clip.xy, beyond ? 0.0 : near_m, clip.z);
    drawn_level = level;
}

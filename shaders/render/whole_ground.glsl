// The ground that a picture shows, where the terrain is held as a whole: what colouring looks at around a hit. tile_ground.glsl
// gives the same of a terrain in tiles.
#include "render/surface.glsl"
#include "maths/cast.glsl"

uniform sampler2D bottoms;

// Lowest sample of all, over the eye.
real load_lowest() { return (texelFetch(bottoms, whole_texel(), 0).r - origin_height_m.x) - origin_height_m.y; }

// What relief.glsl needs.
int2 relief_origin() { return origin_cell; }
int2 relief_first() { return int2(0, 0); }
int2 relief_last() { return patches - 1; }
real2 relief_cell_m() { return cell_m; }

// A place of the picture, in columns and rows from the origin cell, as relief.glsl counts it. detail: of the hit.
real2 relief_place_of(real2 place, real detail) { return place; }

// How far a shadow's ray starts over the ground, so that a hill does not shade its own patch by rounding.
real shadow_lift_m(real distance_m) { return 1e-3 * min(cell_m.x, cell_m.y) + 2e-5 * distance_m; }

// Where a ray from a place of the picture meets the ground, m along it; < 0: nowhere.
real shadow_distance_m(real2 from, real height_m, real3 direction) {
    int2 from_cell = int2(floor(from));
    return cast_ray(origin_cell + from_cell, from - real2(from_cell), direction, 0.0, 2, height_m).distance_m;
}

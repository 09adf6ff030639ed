// The ground that a picture shows, of a terrain in tiles: what colouring looks at around a hit, as whole_ground.glsl has it for
// a terrain that is held as a whole. Heights and slopes are those of the tile that was hit, whose own samples around it are
// enough; so no edge between levels is seen in them.
#ifdef SHADOWS
#define FROM_ELSEWHERE
#endif
#include "render/tile_surface.glsl"
#include "render/tile_hole.glsl"

uniform real tile_lowest_m;
uniform real tile_off_px;  // how far off a level may be, in pixels

int relief_slot = 0;
TilePlace relief_tile = TilePlace(int2(0, 0), real2(0.0, 0.0), real2(1.0, 1.0), 0);

// Lowest sample of all, over the eye.
real load_lowest() { return (tile_lowest_m - origin_height_m.x) - origin_height_m.y; }

// What relief.glsl needs.
int2 relief_origin() { return relief_tile.origin_cell; }
int2 relief_first() { return tile_patches(relief_slot).xy; }
int2 relief_last() { return tile_patches(relief_slot).zw; }
real2 relief_cell_m() { return cell_m / relief_tile.scale; }

// A place of the picture, in columns and rows of the finest level from the eye's cell, as relief.glsl counts it. detail: of
// the hit, the slot of its tile; minus that and 1 on the wall of a hole.
real2 relief_place_of(real2 place, real detail) {
    relief_slot = int(detail < 0.0 ? -1.0 - detail : detail);
    relief_tile = load_tile(relief_slot);
    return relief_tile.fraction + (place - origin_fraction) * relief_tile.scale;
}

// How far a shadow's ray starts over the ground: beside a tile another one may stand higher by what both are off.
real shadow_lift_m(real distance_m) { return 1e-3 * min(cell_m.x, cell_m.y) + max(2e-5 * distance_m, tile_off_px * pixel_m_at(distance_m)); }

#ifdef SHADOWS
// Where a ray from a place of the picture meets the ground, m along it; < 0: nowhere.
real shadow_distance_m(real2 from, real height_m, real3 direction) {
    int2 from_cell = int2(floor(from));
    tile_start = from - origin_fraction;
    return cast_tiles_drawn(origin_cell + from_cell, from - real2(from_cell), direction, 0.0, 30, 0, height_m).distance_m;
}
#endif

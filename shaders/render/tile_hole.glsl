// Casts rays onto the tiles that are drawn; with HOLE, around the patches of a terrain that is drawn in their place
// (render/tiled/backdrop.h).
#include "maths/tile_cast.glsl"

#ifdef HOLE
uniform int2 hole_first;  // its patches of the finest level, from these to before these
uniform int2 hole_end;
#endif

TileHit cast_tiles_drawn(int2 from_cell, real2 fraction, real3 direction, real from_m, int start_level, int first_tile_level,
                         real height_m) {
#ifdef HOLE
    return cast_tiles_around(hole_first, hole_end, from_cell, fraction, direction, from_m, start_level, first_tile_level, height_m);
#else
    return cast_tiles(from_cell, fraction, direction, from_m, start_level, first_tile_level, height_m, real2(0.0, 1e30));
#endif
}

// Every pixel's ray over a tiled terrain.
#ifdef COUNT_STEPS
const bool count_steps = true;
#else
const bool count_steps = false;
#endif
#include "render/picture.glsl"
#include "render/tile_surface.glsl"

layout(location = 0) out vec2 hit_out;  // distance along the ray in metres (infinity: nothing hit), detail

void main() {
    real2 at = picture_position();
    TileHit hit = cast_tiles(origin_cell, origin_fraction, pixel_ray(at), 0.0, 0.0);
    hit_out = vec2(hit.distance_m < 0.0 ? uintBitsToFloat(0x7f800000u) : hit.distance_m, float(hit.steps));
#ifdef TELL_SLOT
    hit_out.y = float(hit.slot);
#endif
}

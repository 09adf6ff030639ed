// Every pixel's ray over a tiled terrain, from where its beam ended; PARALLEL: of a parallel view, from a column and row of its own.
#ifdef PARALLEL
#define NO_BEAMS
#define FROM_ELSEWHERE
#endif
#ifdef COUNT_STEPS
const bool count_steps = true;
#else
const bool count_steps = false;
#endif
#include "render/picture.glsl"
#include "render/tile_surface.glsl"
#include "render/beam_pixels.glsl"
#include "render/tile_hole.glsl"

layout(location = 0) out vec2 hit_out;  // distance along the ray in metres (infinity: nothing hit), detail
uniform sampler2D beams;

void main() {
#ifdef NO_BEAMS
    real2 beam = real2(0.0, 32.0);
#else
    real2 beam = texelFetch(beams, ivec2(gl_FragCoord.xy) / beam_pixels, 0).rg;
#endif
    real2 at = picture_position();
    real from_m = beam.x * length(ray_forward + at.x * ray_right + at.y * ray_up);
    // Beams stop at cells some pixels wide; a ray does best to start two levels finer, and from the tile that is drawn there.
#ifdef PARALLEL
    real3 start = pixel_start(at);
    real2 place = origin_fraction + start.xy;
    real2 cell = floor(place);
    tile_start = start.xy;
    TileHit hit = cast_tiles_drawn(origin_cell + int2(cell), place - cell, pixel_ray(at), 0.0, 1, 0, start.z);
    // Beside the terrain a ray straight down comes to its side endlessly far away (cast_inverse()).
    if (hit.distance_m > 1e12) hit.distance_m = -1.0;
#else
    TileHit hit = cast_tiles_drawn(origin_cell, origin_fraction, pixel_ray(at), from_m, max(int(beam.y) - 2, 1),
                                   int(64.0 * fract(beam.y)), 0.0);
#endif
    hit_out = vec2(hit.distance_m < 0.0 ? uintBitsToFloat(0x7f800000u) : hit.distance_m, float(hit.steps));
#ifdef TELL_SLOT
    hit_out.y = float(hit.slot);
#ifdef HOLE
    // On the wall of the hole: minus the slot and 1.
    if (hit.on_wall) hit_out.y = -1.0 - float(hit.slot);
#endif
#endif
}

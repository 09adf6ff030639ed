// Method "exact": every pixel's ray walks the pyramid to the bilinear surface, from where its beam ended.
#ifdef COUNT_STEPS
const bool count_steps = true;
#else
const bool count_steps = false;
#endif
#include "render/surface.glsl"
#include "render/picture.glsl"
#include "render/beam_pixels.glsl"
#include "maths/cast.glsl"

// PARALLEL: the rays of a parallel view start in columns and rows of their own, with no beam.
layout(location = 0) out vec2 hit_out;  // distance along the ray in metres (infinity: nothing hit), detail
uniform sampler2D beams;

void main() {
#ifdef NO_BEAMS
    real2 beam = real2(0.0, 5.0);
#else
    real2 beam = texelFetch(beams, ivec2(gl_FragCoord.xy) / beam_pixels, 0).rg;
#endif
    real2 at = picture_position();
    real3 ray = pixel_ray(at);
    real from_m = beam.x * length(ray_forward + at.x * ray_right + at.y * ray_up);
#ifdef FLAT_ENDS
    // Rays of a beam that ended in flat ground don't walk: they start beyond everything.
    bool flat_end = beam.y < 0.0;
    from_m = flat_end ? 1e30 : from_m;
#endif
    // Beams stop at cells some pixels wide; a ray does best to start two levels finer.
#ifdef PARALLEL
    real3 start = pixel_start(at);
    real2 place = origin_fraction + start.xy;
    real2 cell = floor(place);
    CastHit hit = cast_ray(origin_cell + int2(cell), place - cell, ray, 0.0, 1, start.z);
    // Beside the terrain a ray straight down comes to its side endlessly far away (cast_inverse()).
    if (hit.distance_m > 1e12) hit.distance_m = -1.0;
#else
    CastHit hit = cast_ray(origin_cell, origin_fraction, ray, from_m, max(int(beam.y) - 2, 1), 0.0);
#endif
#ifdef FLAT_ENDS
    hit.distance_m = flat_end ? beam.x / ray.z : hit.distance_m;
#endif
    hit_out = vec2(hit.distance_m < 0.0 ? uintBitsToFloat(0x7f800000u) : hit.distance_m, float(hit.steps));
#ifdef TELL_KIND
    hit_out.y = 2.0;
#ifdef FLAT_ENDS
    hit_out.y = flat_end ? 2.0 - beam.y : 2.0;
#endif
    if (hit.distance_m < 0.0) hit_out.y = 0.0;
#endif
}

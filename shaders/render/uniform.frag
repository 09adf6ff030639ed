// Method "uniform": samples of a block along the pixel's ray, from where the ray comes under its envelope, or with EYE from an eye
// that is over the block (Jeong & Han 2006). The nearest of all blocks' hits wins.
const bool count_steps = true;
#include "render/surface.glsl"
#include "render/picture.glsl"
#include "render/envelope.glsl"
#include "maths/cast.glsl"
#include "maths/march.glsl"
#include "maths/block_samples.glsl"

layout(location = 0) out vec2 hit_out;  // distance along the ray in metres, detail
#ifndef EYE
layout(depth_less) out float gl_FragDepth;
flat in ivec2 drawn_patch;
#endif

uniform sampler2D bottoms;
uniform real near_m;

CastHit hit_in(int2 patch_at, real3 ray, real from_m) {
    int2 first = (patch_at >> envelope_level) << envelope_level;
    real top_m = load_highest();
    real lowest_m = (texelFetch(bottoms, whole_texel(), 0).r - origin_height_m.x) - origin_height_m.y;
    real relief_m = max(top_m - lowest_m, min(cell_m.x, cell_m.y));
    return sample_block(first, min(first + envelope_patches, patches), top_m, relief_m, from_m, origin_cell, origin_fraction, ray);
}

CastHit nearer(CastHit a, CastHit b) { return b.distance_m >= 0.0 && (a.distance_m < 0.0 || b.distance_m < a.distance_m) ? b : a; }

// Whether a point of the ray lies so close over the ground, as the picture shows it, that the rasteriser may place it on either
// side of a line on the ground: within 1/8 of a pixel below, as vertices snap to 1/256 and the line may be steep.
bool beside_ground(real at_m, real3 ray) {
    return march_above(origin_cell, origin_fraction, ray, at_m) * length(ray.xy * cell_m) < at_m * (length(ray_up) / (4.0 * picture_size.y));
}

// In the block of a front face, and in those before and behind it whose own front face the pixel may have missed by snapping.
CastHit hit_around(int2 patch_at, real3 ray, real from_m) {
    int2 block = patch_at >> envelope_level;
    int2 first = block << envelope_level;
    int2 last = min(first + envelope_patches, patches);
    CastHit hit = hit_in(patch_at, ray, from_m);
    real2 inverse = real2(cast_inverse(ray.x), cast_inverse(ray.y));
    bvec2 forward = greaterThanEqual(ray.xy, real2(0.0));
    real2 enter = cast_planes(mix(last, first, forward) - origin_cell, origin_fraction, inverse);
    real2 leave = cast_planes(mix(first, last, forward) - origin_cell, origin_fraction, inverse);
    int2 onward = mix(int2(-1), int2(1), forward);
    real begin = max(enter.x, enter.y);
    real end = min(leave.x, leave.y);
    int2 behind = block - (enter.x > enter.y ? int2(onward.x, 0) : int2(0, onward.y));
    int2 ahead = block + (leave.x < leave.y ? int2(onward.x, 0) : int2(0, onward.y));
    int2 blocks = (patches - 1) >> envelope_level;
    if (begin > 0.0 && clamp(behind, int2(0), blocks) == behind && beside_ground(begin, ray))
        hit = nearer(hit, hit_in(behind << envelope_level, ray, 0.0));
    if (end > 0.0 && hit.distance_m < 0.0 && clamp(ahead, int2(0), blocks) == ahead && beside_ground(end, ray))
        hit = hit_in(ahead << envelope_level, ray, 0.0);
    return hit;
}

void main() {
    real2 at = picture_position();
    real ray_length = length(ray_forward + at.x * ray_right + at.y * ray_up);
    real3 ray = pixel_ray(at);
#ifdef EYE
    CastHit hit = hit_in(origin_cell, ray, 0.0);
#else
    real from_m = ray_length / gl_FragCoord.w;
    CastHit hit = hit_around(drawn_patch, ray, from_m);
    // Near a side that blocks share, rounding says which of them the ray is over, and it may run along that side.
    real2 place = origin_fraction + 1.00001 * from_m * ray.xy;
    int2 patch_ahead = min(max(origin_cell + int2(floor(place)), int2(0)), patches - 1);
    if ((patch_ahead >> envelope_level) != (drawn_patch >> envelope_level)) hit = nearer(hit, hit_in(patch_ahead, ray, 0.0));
#endif
    if (hit.distance_m < 0.0) discard;
    hit_out = vec2(hit.distance_m, float(hit.steps));
#ifdef TELL_KIND
    hit_out.y = 2.0;
#endif
    real depth = near_m * ray_length / max(hit.distance_m, 1e-20);
#ifdef EYE
    gl_FragDepth = min(depth, 1.0);
#else
    gl_FragDepth = min(depth, gl_FragCoord.z);
#endif
}

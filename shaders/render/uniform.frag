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

void main() {
    real2 at = picture_position();
    real ray_length = length(ray_forward + at.x * ray_right + at.y * ray_up);
    real3 ray = pixel_ray(at);
#ifdef EYE
    CastHit hit = hit_in(origin_cell, ray, 0.0);
#else
    real from_m = ray_length / gl_FragCoord.w;
    CastHit hit = hit_in(drawn_patch, ray, from_m);
    // Near a side that blocks share, rounding says which of them the ray is over, and it may run along that side.
    real2 place = origin_fraction + 1.00001 * from_m * ray.xy;
    int2 patch_ahead = min(max(origin_cell + int2(floor(place)), int2(0)), patches - 1);
    if ((patch_ahead >> envelope_level) != (drawn_patch >> envelope_level)) {
        CastHit ahead = hit_in(patch_ahead, ray, from_m);
        if (ahead.distance_m >= 0.0 && (hit.distance_m < 0.0 || ahead.distance_m < hit.distance_m)) hit = ahead;
    }
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

// Method "ammann": a ray through a cell's box, marched with SAMPLES steps and HALVINGS (Ammann, Génevaux & Dischler 2010, section
// 3). The nearest of all cells' hits wins.
const bool count_steps = true;
#include "render/surface.glsl"
#include "render/picture.glsl"
#include "render/cell_grid.glsl"
#include "maths/cast.glsl"
#include "maths/march.glsl"

layout(location = 0) out vec2 hit_out;  // distance along the ray in metres, detail
layout(depth_less) out float gl_FragDepth;

uniform sampler2D cell_bounds;
uniform real near_m;
uniform real kind;  // what drew the pixel

flat in ivec2 drawn_cell;

void main() {
    real2 at = picture_position();
    real2 bounds_m = (texelFetch(cell_bounds, drawn_cell, 0).rg - origin_height_m.x) - origin_height_m.y;
    int2 first = drawn_cell * cell_patches;
    CastHit hit = march_box(first, min(first + cell_patches, patches), bounds_m, origin_cell, origin_fraction, pixel_ray(at), SAMPLES, HALVINGS);
    if (hit.distance_m < 0.0) discard;
    hit_out = vec2(hit.distance_m, float(hit.steps));
#ifdef TELL_KIND
    hit_out.y = kind;
#endif
    real depth_m = hit.distance_m / length(ray_forward + at.x * ray_right + at.y * ray_up);
    gl_FragDepth = min(near_m / depth_m, gl_FragCoord.z);
}

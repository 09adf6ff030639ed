// Which hits of a picture one ground shades that are another one's: 1, else 0. The ground that shades is GROUND_FILE's, with the camera in its
// own columns and rows; the hits are along the same rays.
#define SHADOWS
const bool count_steps = false;
#include "render/picture.glsl"
#include GROUND_FILE

layout(location = 0) out vec4 shade_out;

uniform sampler2D hits;
uniform real3 sun;          // towards it: east, north, up
uniform real other_off_px;  // how far off the other ground may be, in pixels

void main() {
    vec2 hit = texelFetch(hits, ivec2(gl_FragCoord.xy), 0).rg;
    real distance_m = hit.r;
    shade_out = vec4(0.0);
    if (isinf(distance_m)) return;
#ifdef SKIPS_WALLS
    // Hits on the walls of the hole have a detail below 0 (render/tiled/tiled_rays.h).
    if (hit.g < 0.0) return;
#endif
    vec3 ray = pixel_ray(picture_position());
    vec3 start = pixel_start(picture_position());
    vec2 place = origin_fraction + start.xy + distance_m * ray.xy;
    real lift = shadow_lift_m(distance_m) + other_off_px * pixel_m_at(distance_m);
    vec3 to_sun = vec3(sun.x / cell_m.x, -sun.y / cell_m.y, sun.z);
    bool shaded = shadow_distance_m(place - ray.xy * lift, start.z + distance_m * ray.z + 2.0 * lift, to_sun) > lift;
    shade_out = vec4(shaded ? 1.0 : 0.0);
}

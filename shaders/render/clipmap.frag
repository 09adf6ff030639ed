// Method "clipmap": the distance along the pixel's ray, from the depth buffer's value, since triangles of the terrain's sides have a
// corner at infinity.
#include "maths/glsl_types.glsl"
#include "render/picture.glsl"

layout(location = 0) out vec2 hit_out;

uniform real near_m;

uniform real3 kinds;  // of the levels, three in turn

flat in int drawn_level;

void main() {
    real2 at = picture_position();
    hit_out = vec2(near_m / gl_FragCoord.z * length(ray_forward + at.x * ray_right + at.y * ray_up), 1.0);
#ifdef TELL_KIND
    hit_out.y = kinds[drawn_level % 3];
#endif
}

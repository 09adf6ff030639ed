// Method "mesh": the distance along the pixel's ray is its depth along the view times the ray's length there.
#include "maths/glsl_types.glsl"
#include "render/picture.glsl"

layout(location = 0) out vec2 hit_out;

#ifdef WALLS
uniform real near_m;
#endif

void main() {
    real2 at = picture_position();
#ifdef WALLS
    // Triangles with a corner at infinity: the depth buffer's value is what tells the depth.
    real depth = near_m / gl_FragCoord.z;
#else
    real depth = 1.0 / gl_FragCoord.w;
#endif
    hit_out = vec2(depth * length(ray_forward + at.x * ray_right + at.y * ray_up), 1.0);
}

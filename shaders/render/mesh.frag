// Method "mesh": the distance along the pixel's ray is its depth along the view times the ray's length there.
#include "maths/glsl_types.glsl"
#include "render/picture.glsl"

layout(location = 0) out vec2 hit_out;

void main() {
    real2 at = picture_position();
    hit_out = vec2(length(ray_forward + at.x * ray_right + at.y * ray_up) / gl_FragCoord.w, 0.0);
}

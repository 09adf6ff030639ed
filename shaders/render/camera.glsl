// The camera's rays, as render/camera.h sets them.
#include "maths/glsl_types.glsl"

uniform real2 picture_size;
uniform real2 cells_per_m;
uniform real3 ray_forward;
uniform real3 ray_right;
uniform real3 ray_up;
#include "maths/pixel_ray.glsl"

// Where a point (metres from the eye: east, north, up) lies in the picture, times its depth along the view, and that
// depth: the picture is |x| <= z, |y| <= z.
real3 clip_of(real3 point) {
    return real3(dot(point, ray_right) / dot(ray_right, ray_right), dot(point, ray_up) / dot(ray_up, ray_up), dot(point, ray_forward));
}

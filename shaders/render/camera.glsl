// The camera's rays, as render/camera.h sets them.
#include "maths/glsl_types.glsl"

uniform real2 picture_size;
uniform real2 cells_per_m;
uniform real3 view_axis;    // unit vector that depth is measured along
uniform real3 ray_forward;  // to the picture's middle, at depth one
uniform real3 ray_right;
uniform real3 ray_up;
#include "maths/pixel_ray.glsl"

// Where a point (metres from the eye: east, north, up) lies in the picture, times its depth along the view, and that
// depth: the picture is |x| <= z, |y| <= z.
real3 clip_of(real3 point) {
    real depth = dot(point, view_axis);
    real3 aside = point - depth * ray_forward;
    return real3(dot(aside, ray_right) / dot(ray_right, ray_right), dot(aside, ray_up) / dot(ray_up, ray_up), depth);
}

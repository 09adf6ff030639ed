// The camera's rays, as render/camera.h sets them.
#include "maths/glsl_types.glsl"

uniform real2 picture_size;
uniform real2 cells_per_m;
uniform real3 view_axis;    // unit vector that depth is measured along
uniform real3 ray_forward;  // to the picture's middle, at depth one
uniform real3 ray_right;
uniform real3 ray_up;
uniform real3 start_m;      // of parallel rays: where the picture's middle one starts, from the eye; 0: all start in the eye
uniform real3 start_right_m;
uniform real3 start_up_m;
uniform real2 pixel_width_m;  // of a pixel: x, and y times the distance along its ray
#include "maths/pixel_ray.glsl"

// Where a pixel's ray starts, metres from the eye: east, north, up.
real3 pixel_start_m(real2 picture) { return start_m + picture.x * start_right_m + picture.y * start_up_m; }

// The same in columns, rows and metres.
real3 pixel_start(real2 picture) {
    real3 from_m = pixel_start_m(picture);
    return real3(from_m.x * cells_per_m.x, -from_m.y * cells_per_m.y, from_m.z);
}

real pixel_m_at(real distance_m) { return pixel_width_m.x + distance_m * pixel_width_m.y; }

// Where a point (metres from the eye: east, north, up) lies in the picture, times its depth along the view, and that
// depth: the picture is |x| <= z, |y| <= z.
real3 clip_of(real3 point) {
    real depth = dot(point, view_axis);
    real3 aside = point - start_m - depth * ray_forward;
    if (pixel_width_m.x > 0.0)
        return depth * real3(dot(aside, start_right_m) / dot(start_right_m, start_right_m), dot(aside, start_up_m) / dot(start_up_m, start_up_m), 1.0);
    return real3(dot(aside, ray_right) / dot(ray_right, ray_right), dot(aside, ray_up) / dot(ray_up, ray_up), depth);
}

// Lines of equal height.
uniform real band_m;  // interval
#include "render/contours.glsl"

vec3 view_colour(ViewPoint point) {
    return mix(vec3(0.93, 0.91, 0.86) * point.lit, vec3(0.36, 0.22, 0.12), contour_ink(point.distance_m, point.ray));
}

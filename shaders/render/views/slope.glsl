// How steep the ground is.
uniform real slope_scale_deg;

vec3 view_colour(ViewPoint point) {
    return colour_map(atan(length(point.relief.gradient)) * 180.0 / pi / slope_scale_deg) * (0.75 + 0.25 * point.normal.z);
}

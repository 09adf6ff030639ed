// Depth of the regolith.
uniform real regolith_scale_m;

float view_value(vec2 place) {
    vec2 depth = layer_at(solid, place, 0).zw;
    return depth.x + depth.y;
}

vec3 view_colour(ViewPoint point) {
    vec2 depth = layer_at(solid, point.place, 0).zw;
    return depth.x > 0.0 ? colour_map((depth.x + depth.y) / regolith_scale_m) * point.lit : bare * point.lit;
}

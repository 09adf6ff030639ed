// Where the slope faces, clockwise from north; the flatter, the greyer.

vec3 view_colour(ViewPoint point) {
    vec2 gradient = point.relief.gradient;
    float facing = atan(-gradient.x, -gradient.y) / (2.0 * pi);
    return mix(vec3(0.6), direction_map(facing), smoothstep(0.0, 0.05, length(gradient))) * point.lit;
}

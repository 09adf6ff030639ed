// What the ground gained or lost since the start.
uniform real difference_m;  // end of the scale

// What the ground gained since the terrain was made.
float ground_change(vec2 place) {
    ivec2 cell = clamp(origin_cell + ivec2(floor(place)), ivec2(0), patches - 1);
    vec2 w = clamp(place - vec2(cell - origin_cell), 0.0, 1.0);
    vec4 change;
    for (int i = 0; i < 4; ++i) {
        ivec2 at = cell + ivec2(i & 1, i >> 1);
        vec2 before = texelFetch(start, at, 0).rg;
        change[i] = (texelFetch(ground, at, 0).r - before.x) - before.y;
    }
    return mix(mix(change.x, change.y, w.x), mix(change.z, change.w, w.x), w.y);
}

float view_value(vec2 place) { return abs(ground_change(place)); }

vec3 view_colour(ViewPoint point) { return difference_map(0.5 + 0.5 * ground_change(point.place) / difference_m) * point.lit; }

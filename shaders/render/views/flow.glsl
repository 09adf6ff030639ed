// Water that went through so far, by powers of ten.
uniform sampler2D layer;      // m³, two words
uniform real flow_scale_m3;   // end of the scale
uniform real flow_decades;    // powers of ten from its beginning to there

float view_value(vec2 place) { return layer_at(layer, place, 0).x; }

vec3 view_colour(ViewPoint point) {
    float share = view_value(point.place) / flow_scale_m3;
    float part = 1.0 + 0.30102999566 * log2(max(share, 1e-30)) / flow_decades;
    return colour_map(part) * point.lit;
}

// The painted mask.
uniform sampler2D layer;  // hardness, mask, rain

vec3 view_colour(ViewPoint point) {
    float share = layer_at(layer, point.place, 0).y;
    return (share > 0.0 ? colour_map(share) : bare) * point.lit;
}

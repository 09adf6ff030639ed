// Painted rain.
uniform sampler2D layer;  // hardness, mask, rain
uniform real rain_scale;  // mm/h

vec3 view_colour(ViewPoint point) {
    float share = layer_at(layer, point.place, 0).z / rain_scale;
    return (share > 0.0 ? colour_map(share) : bare) * point.lit;
}

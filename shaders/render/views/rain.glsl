// Painted rain.
uniform sampler2D layer;  // hardness, mask, rain
uniform real rain_scale;  // mm/h

float view_value(vec2 place) { return layer_at(layer, place, 0).z; }

vec3 view_colour(ViewPoint point) {
    float share = view_value(point.place) / rain_scale;
    return (share > 0.0 ? colour_map(share) : bare) * point.lit;
}

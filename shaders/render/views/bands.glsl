// Bands of height.
uniform real band_m;  // interval

vec3 view_colour(ViewPoint point) {
    float band = floor(point.height_m / band_m);
    float bottom_band = floor((point.lowest_m + origin_height_m.x) / band_m);
    float top_band = floor((point.highest_m + origin_height_m.x) / band_m);
    return colour_map((band - bottom_band) / max(top_band - bottom_band, 1.0)) * point.lit;
}

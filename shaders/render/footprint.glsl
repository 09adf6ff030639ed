// How far a pixel reaches on the ground: where the rays of the pixels to its right and above meet the ground's tangent
// plane (Dick, Krueger & Westermann 2009, section 3.3), for textures that are filtered along and across the view alike.
struct Footprint {
    vec2 right;  // in columns and rows
    vec2 up;
};

// way: the pixel's ray before normalisation; normal: of the ground, east, north, up.
Footprint footprint_of(vec3 way, vec3 normal, float distance_m) {
    float length_m = length(way);
    vec3 ray = way / length_m;
    // Limits the footprint at grazing angles, where detail is faded anyway.
    float facing = min(dot(ray, normal), -0.02);
    vec3 step_right = ray_right * (2.0 / (picture_size.x * length_m));
    vec3 step_up = ray_up * (2.0 / (picture_size.y * length_m));
    step_right = distance_m * step_right + start_right_m * (2.0 / picture_size.x);
    step_up = distance_m * step_up + start_up_m * (2.0 / picture_size.y);
    step_right -= ray * (dot(step_right, normal) / facing);
    step_up -= ray * (dot(step_up, normal) / facing);
    Footprint footprint;
    footprint.right = vec2(step_right.x, -step_right.y) * cells_per_m;
    footprint.up = vec2(step_up.x, -step_up.y) * cells_per_m;
    return footprint;
}

// For the filter of the device. One that filters as wide across as along does best with a width between both.
Footprint for_device(Footprint footprint) {
#ifdef FILTERS_ROUND
    float right = length(footprint.right);
    float up = length(footprint.up);
    float most = 2.0 * min(right, up);
    footprint.right *= min(1.0, most / max(right, 1e-20));
    footprint.up *= min(1.0, most / max(up, 1e-20));
#endif
    return footprint;
}

uniform float texture_taps;  // at most, of filtered_along()

// Of a footprint in texels: how many taps are taken along its longer side, as in EXT_texture_filter_anisotropic.
float footprint_taps(float longer, float shorter) {
    // Of an image that is magnified one tap is the same as many.
    return clamp(ceil(longer / max(shorter, 1.0)), 1.0, texture_taps);
}

// And how many texels each of them stands for.
float footprint_texel(vec2 right, vec2 up) {
    float longer = max(length(right), length(up));
    return longer / footprint_taps(longer, min(length(right), length(up)));
}

// The mean of an image over a footprint, given in shares of its sides: taps evenly over the longer side. No tap lies beyond
// low and high.
vec4 filtered_along(sampler2D image, vec2 place, Footprint footprint, vec2 low, vec2 high) {
    vec2 size = vec2(textureSize(image, 0));
    float right = length(footprint.right * size);
    float up = length(footprint.up * size);
    vec2 along = right > up ? footprint.right : footprint.up;
    float longer = max(right, up);
    float taps = footprint_taps(longer, min(right, up));
    float level = log2(max(longer / taps, 1.0));
    vec2 between = along / taps;
    vec2 at = place - 0.5 * (taps - 1.0) * between;
    vec4 sum = vec4(0.0);
    float tap = 0.0;
    do {
        sum += textureLod(image, clamp(at, low, high), level);
        at += between;
        tap += 1.0;
    } while (tap < taps);
    return sum / taps;
}

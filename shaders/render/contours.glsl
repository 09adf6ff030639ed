// Contour lines of constant width. The including side has `hits` and picture.glsl.

// Height over the datum where a pixel beside this one hit; the eye's where it hit nothing.
float height_beside(ivec2 pixel) {
    float distance_m = texelFetch(hits, clamp(pixel, ivec2(0), ivec2(picture_size) - 1), 0).r;
    vec2 at = vec2(2.0 * (vec2(pixel) + 0.5) / picture_size - 1.0);
    return origin_height_m.x + (isinf(distance_m) ? 0.0 : pixel_start(at).z + distance_m * pixel_ray(at).z);
}

// How much ink of contour lines a pixel carries: lines as wide everywhere, every fifth bolder. Their distance in pixels
// is the distance in height over the height's change from pixel to pixel.
float contour_ink(float distance_m, vec3 ray) {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float height_m = origin_height_m.x + distance_m * ray.z;
    vec2 east = vec2(height_beside(pixel + ivec2(1, 0)) - height_m, height_m - height_beside(pixel - ivec2(1, 0)));
    vec2 north = vec2(height_beside(pixel + ivec2(0, 1)) - height_m, height_m - height_beside(pixel - ivec2(0, 1)));
    // The smaller of both sides: a crest before something far is no slope.
    float change = length(vec2(min(abs(east.x), abs(east.y)), min(abs(north.x), abs(north.y))));
    // On level ground at just a line's height there is no line, only rounding of the heights.
    float rounding = 4e-7 * max(distance_m, abs(height_m));
    float sloping = smoothstep(rounding, 4.0 * rounding, change);
    float ink = 0.0;
    for (int i = 0; i < 2; ++i) {
        float interval = i == 0 ? band_m : 5.0 * band_m;
        float off = abs(height_m / interval - floor(height_m / interval + 0.5)) * interval;
        float pixels = off / max(change, 1e-6 * interval);
        // Where lines would run together there is a tone.
        float apart = interval / max(change, 1e-6 * interval);
        float width = i == 0 ? 0.5 : 1.0;
        ink = max(ink, (i == 0 ? 0.7 : 0.9) * (1.0 - smoothstep(width, width + 1.0, pixels)) * smoothstep(2.0, 6.0, apart));
    }
    return ink * sloping;
}

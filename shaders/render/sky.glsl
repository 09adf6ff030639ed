// What is added to a colour before it is rounded to 8 bits, so that slow gradients show no bands: noise of the pixel's
// own, half a step to either side (PCG hash, Jarzynski & Olano 2020).
float dither(ivec2 pixel) {
    uint state = uint(pixel.x) * 747796405u + uint(pixel.y) * 2891336453u + 2891336453u;
    uint word = ((state >> ((state >> 28) + 4u)) ^ state) * 277803737u;
    word = (word >> 22) ^ word;
    return (float(word >> 8) / 16777216.0 - 0.5) / 255.0;
}

// The colour of the sky in a direction (east, north, up), linear; `sun` is the unit vector towards the sun.
vec3 sky(vec3 direction) {
    float up = max(direction.z, 0.0);
    vec3 colour = mix(vec3(0.80, 0.87, 0.94), vec3(0.28, 0.49, 0.79), 1.0 - exp(-3.5 * up));
    float near_sun = max(dot(direction, sun), 0.0);
    colour += vec3(1.0, 0.85, 0.6) * (0.12 * pow(near_sun, 8.0) + 0.6 * pow(near_sun, 900.0));
    return direction.z < 0.0 ? mix(colour, vec3(0.62, 0.69, 0.76), min(-direction.z * 6.0, 1.0)) : colour;
}

// How much of the air's light lies over what is so far away; from the top, as on a map, none. The including side has `extent_m`
// and camera.glsl.
float haze_at(float distance_m) { return pixel_width_m.x > 0.0 ? 0.0 : 1.0 - exp(-0.16 * distance_m / extent_m); }

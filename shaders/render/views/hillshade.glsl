// Light alone.
uniform real hillshade_from;  // 0: the sun; 1: four sides

// Hillshade lit from south-west, west, north-west and north, each where slopes would else lie in one light (Mark 1992).
float four_lights(vec2 gradient, vec3 normal) {
    float facing = atan(-gradient.x, -gradient.y);
    float low = sqrt(max(1.0 - sun.z * sun.z, 0.0));
    float light = 0.0;
    float weights = 0.0;
    for (int i = 0; i < 4; ++i) {
        float azimuth = (225.0 + 45.0 * float(i)) * pi / 180.0;
        float across = sin(facing - azimuth);
        float weight = across * across + 0.05;
        light += weight * max(dot(normal, vec3(low * sin(azimuth), low * cos(azimuth), sun.z)), 0.0);
        weights += weight;
    }
    return light / weights;
}

vec3 view_colour(ViewPoint point) {
    return vec3(hillshade_from > 0.5 ? four_lights(point.relief.gradient, point.normal) : max(dot(point.normal, sun), 0.0));
}

// As in nature: materials or an image, sun, shadow, the sky's share, haze.
// What of the sun's light comes here, past what stands between; 0 or 1.
float sunlight_at(vec2 place, vec3 ray, float above_eye, float distance_m) {
#ifdef SHADOWS
    // From a little above the ground, towards the eye.
    float lift = shadow_lift_m(distance_m);
    vec3 to_sun = vec3(sun.x / cell_m.x, -sun.y / cell_m.y, sun.z);
    return shadow_distance_m(place - ray.xy * lift, above_eye + 2.0 * lift, to_sun) > lift ? 0.0 : 1.0;
#else
    return 1.0;
#endif
}

vec3 view_colour(ViewPoint point) {
    Footprint footprint = footprint_of(ray_forward + point.at.x * ray_right + point.at.y * ray_up, point.normal, point.distance_m);
#ifdef DRAPED
    vec3 albedo = draped(point.absolute, footprint);
#elif defined(PHOTO)
    vec4 photo = photo_at(point.place - origin_fraction, footprint);
    vec3 albedo = paper * photo.rgb;
#ifndef PHOTO_COVERS
    albedo += (1.0 - photo.a) * material(material_place(point.absolute), footprint, point.share, point.height_m, point.highest_m - point.lowest_m, point.relief);
#endif
#else
    vec3 albedo = material(material_place(point.absolute), footprint, point.share, point.height_m, point.highest_m - point.lowest_m, point.relief);
#endif
    float light = max(dot(point.normal, sun), 0.0);
#ifdef BESIDE
    light *= 1.0 - texelFetch(beside_shadow, ivec2(gl_FragCoord.xy), 0).r;
#endif
    light *= light > 0.0 && !point.missed ? sunlight_at(point.place, point.ray, point.above_eye_m, point.distance_m) : 1.0;
    vec3 ambient = mix(vec3(0.16, 0.15, 0.13), vec3(0.36, 0.46, 0.62), 0.5 + 0.5 * point.normal.z) * sky_share_at(point.absolute);
    vec3 colour = albedo * (light * vec3(3.5, 3.2, 2.75) + 0.9 * ambient);
    float haze = haze_at(point.distance_m);
    colour = mix(colour, sky(normalize(vec3(point.world_ray.xy, 0.06))), 0.85 * haze);
    // Bright snow keeps its shades: what exceeds the screen's range is drawn together towards white.
    colour *= (1.0 + colour / 6.25) / (1.0 + 0.45 * colour);
    return sqrt(clamp(colour, 0.0, 1.0));
}

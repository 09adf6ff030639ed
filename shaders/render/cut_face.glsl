// The sides where the terrain's rectangle is cut off: layers of rock, fading out below. place: absolute columns and rows.
// The layers bend as often along the sides of a large terrain as along those of a small one.
vec3 cut_face(float above_eye, float lowest, float highest, vec3 backdrop, vec2 place) {
    float relief = max(highest - lowest, 1e-3 * extent_m);
    float depth = (above_eye - lowest) / relief;
    place *= 512.0 / float(max(patches.x, patches.y));
    float bend = depth * 14.0 + 0.7 * sin(0.031 * (place.x + place.y)) + 0.3 * sin(0.117 * (place.x - place.y));
    uint n = uint(int(floor(bend)) + 64) * 1597334677u;
    float layer = float(((n ^ (n >> 15)) * 2246822519u >> 13) & 0xffu) / 255.0;
    vec3 rock = mix(vec3(0.34, 0.31, 0.28), vec3(0.45, 0.41, 0.37), layer) * (0.93 + 0.07 * smoothstep(0.0, 0.15, fract(bend)));
    return mix(backdrop, rock, smoothstep(-0.42, -0.05, depth));
}

// What the ground is made of: meadow, forest, heath, rock, scree and snow by height, steepness, curvature and loose cover;
// or an image draped over it. Albedo, linear. The including side has footprint.glsl.
uniform float snow_line_m;
uniform float vegetation;  // 0: a desert
uniform float rock_kind;   // of the colours below
uniform sampler2D grain;  // render/grain.h: broad, middle, fine, finest
uniform sampler2D drape;

const float paper = 0.45;  // an image's white: as bright under a middling sun as on paper

// The grain over absolute columns and rows: one texture at two scales, turned against each other, so that it does not repeat
// before the eye.
vec4 grain_at(vec2 place, Footprint footprint) {
    const float near = 1.0 / 160.0;
    const mat2 turned = mat2(0.8, 0.6, -0.6, 0.8) * (1.0 / 1130.0);
    vec4 close = textureGrad(grain, place * near, footprint.right * near, footprint.up * near);
    vec4 wide = textureGrad(grain, turned * place, turned * footprint.right, turned * footprint.up);
    // For ground before the feet; far away it is even.
    const float nearest = 1.0 / 11.0;
    vec4 detail = textureGrad(grain, place * nearest, footprint.right * nearest, footprint.up * nearest);
    return vec4(0.5 * (close.x + wide.y), 0.5 * (close.y + wide.w), 0.5 * (close.z + detail.y), 0.5 * (close.w + detail.z));
}

vec3 draped(vec2 place, Footprint footprint) {
    // Its edges lie on the outer samples.
    vec2 scale = 1.0 / vec2(patches);
    footprint.right *= scale;
    footprint.up *= scale;
    return paper * filtered_along(drape, place * scale, footprint, vec2(0.0), vec2(1.0)).rgb;
}

// A layer between its four samples, at absolute columns and rows.
vec4 between_samples(sampler2D layer, vec2 place) {
    ivec2 cell = clamp(ivec2(floor(place)), ivec2(0), patches - 1);
    vec2 w = clamp(place - vec2(cell), 0.0, 1.0);
    vec4 a = mix(texelFetch(layer, cell, 0), texelFetch(layer, cell + ivec2(1, 0), 0), w.x);
    vec4 b = mix(texelFetch(layer, cell + ivec2(0, 1), 0), texelFetch(layer, cell + 1, 0), w.x);
    return mix(a, b, w.y);
}

#ifdef TILED
float regolith_at(vec2 place) { return 0.0; }
#else
float regolith_at(vec2 place) { return between_samples(solid, place).b; }
#endif

#ifdef MASKED
uniform sampler2D painted;  // hardness, mask, rain
uniform float masked_kind;  // from 1: meadow, forest, rock, scree, sand, snow
#endif

// Granite, sandstone, basalt, limestone: against the first.
const vec3 rock_tints[4] = vec3[4](vec3(1.0), vec3(1.22, 0.84, 0.66), vec3(0.42, 0.42, 0.45), vec3(1.45, 1.42, 1.32));

// place: absolute columns and rows; share: of the terrain's relief (m) that lies below.
vec3 material(vec2 place, Footprint footprint, float share, float height_m, float relief_m, Relief relief) {
    vec4 noise = grain_at(place, for_device(footprint));
    float broad = noise.x;
    float grain = 0.45 * noise.y + 0.55 * noise.z;
    float steep = length(relief.gradient);
    // Hollows gather soil and snow, ridges are blown bare.
    float hollow = clamp(3.0 * relief.hollow, -1.0, 1.0);
    float level = share + 0.10 * (broad - 0.5) + 0.04 * (grain - 0.5);
    vec3 forest = mix(vec3(0.045, 0.068, 0.026), vec3(0.070, 0.092, 0.034), grain);
    vec3 meadow = mix(vec3(0.082, 0.105, 0.038), vec3(0.120, 0.128, 0.055), grain);
    vec3 heath = mix(vec3(0.155, 0.130, 0.075), vec3(0.190, 0.165, 0.105), grain);
    vec3 rock = mix(vec3(0.120, 0.108, 0.098), vec3(0.235, 0.222, 0.208), 0.35 * broad + 0.65 * grain);
    vec3 scree = mix(vec3(0.240, 0.215, 0.180), vec3(0.330, 0.300, 0.260), grain);
    vec3 cover = mix(meadow, forest, 0.6 * smoothstep(0.35, 0.65, broad + 0.25 * (grain - 0.5) + 0.12 * hollow) * (1.0 - smoothstep(0.30, 0.42, level)));
    cover = mix(cover, heath, smoothstep(0.34, 0.52, level - 0.05 * hollow));
    vec3 tint = rock_tints[int(rock_kind + 0.5)];
    rock *= tint;
    scree *= tint;
    cover = mix(0.9 * scree, cover, vegetation);
    vec3 colour = mix(cover, rock, smoothstep(0.46, 0.80, steep + 0.45 * (level - 0.45) + 0.12 * (grain - 0.5) - 0.14 * hollow));
    colour = mix(colour, scree, 0.85 * (1.0 - exp(-max(regolith_at(place), 0.0) / 2.5)));
    float facing_north = normalize(vec3(-relief.gradient, 1.0)).y;
    // Over the line by so much of the relief, so that its edge is as ragged on a hill as on a range.
    float over = level - share + (height_m - snow_line_m) / max(relief_m, 1e-3);
    float snow = smoothstep(-0.06, 0.06, over + 0.06 * facing_north + 0.05 * hollow) * (1.0 - smoothstep(0.62, 1.05, steep - 0.12 * hollow));
    const vec3 white = vec3(0.80, 0.83, 0.88);
    colour = mix(colour, white, snow);
#ifdef MASKED
    vec3 sand = mix(vec3(0.42, 0.35, 0.24), vec3(0.54, 0.47, 0.34), grain);
    vec3 kinds[6] = vec3[6](meadow, forest, rock, scree, sand, white);
    // Its edge is as ragged as that of snow.
    colour = mix(colour, kinds[int(masked_kind - 0.5)], smoothstep(0.25, 0.75, between_samples(painted, place).g + 0.3 * (grain - 0.5)));
#endif
    return colour * (0.55 + 0.9 * noise.w);
}

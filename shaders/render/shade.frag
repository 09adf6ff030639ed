// Colours what a method hit: position, filtered normal, material, sun, shadow, haze; or one of the views.
const bool count_steps = false;
#include "render/surface.glsl"
#include "render/picture.glsl"
#include "maths/cast.glsl"
#include "maths/colour_map.glsl"

layout(location = 0) out vec4 colour_out;

layout(binding = 2) uniform sampler2D bottoms;
layout(binding = 3) uniform sampler2D solid;  // bedrock, its low word, regolith, its low word
layout(binding = 4) uniform sampler2D hits;
layout(binding = 5) uniform sampler2D start;  // the ground when the terrain was made, two words

uniform int view;            // as in render/view.h
uniform real3 sun;           // towards it: east, north, up
uniform int shadows;
uniform real extent_m;       // of the terrain, sets the haze
uniform real pixel_angle;    // radians that a pixel covers
uniform real band_m;         // height bands: interval
uniform real slope_scale_deg;
uniform real steps_scale;
uniform real difference_m;   // view of the difference: end of its scale
uniform int hillshade_lights;  // 1: the sun; 4: from four sides

const float pi = 3.14159265;

// Height over the eye at a place in columns and rows from the origin cell.
float height_at(vec2 place) {
    ivec2 cell = clamp(origin_cell + ivec2(floor(place)), ivec2(0), patches - 1);
    vec2 w = clamp(place - vec2(cell - origin_cell), 0.0, 1.0);
    return patch_height(load_corners(cell), w);
}

// Slope east and north over `reach` cells to each side, so that distant ground does not sparkle.
vec2 gradient_at(vec2 place, float reach) {
    vec2 low = vec2(-origin_cell);
    vec2 high = vec2(patches - origin_cell);
    vec2 west = clamp(place - vec2(reach, 0.0), low, high);
    vec2 east = clamp(place + vec2(reach, 0.0), low, high);
    vec2 north = clamp(place - vec2(0.0, reach), low, high);
    vec2 south = clamp(place + vec2(0.0, reach), low, high);
    return vec2((height_at(east) - height_at(west)) / max((east.x - west.x) * cell_m.x, 1e-6),
                (height_at(north) - height_at(south)) / max((south.y - north.y) * cell_m.y, 1e-6));
}

vec3 sky(vec3 direction) {
    float up = max(direction.z, 0.0);
    vec3 colour = mix(vec3(0.80, 0.87, 0.94), vec3(0.28, 0.49, 0.79), 1.0 - exp(-3.5 * up));
    float near_sun = max(dot(direction, sun), 0.0);
    colour += vec3(1.0, 0.85, 0.6) * (0.12 * pow(near_sun, 8.0) + 0.6 * pow(near_sun, 900.0));
    return direction.z < 0.0 ? mix(colour, vec3(0.62, 0.69, 0.76), min(-direction.z * 6.0, 1.0)) : colour;
}

float hash(ivec2 p) {
    uint n = uint(p.x) * 1597334677u ^ uint(p.y) * 3812015801u;
    n = (n ^ (n >> 15)) * 2246822519u;
    return float((n ^ (n >> 13)) & 0xffffu) / 65535.0;
}

float smooth_hash(vec2 at) {
    ivec2 cell = ivec2(floor(at));
    vec2 f = smoothstep(0.0, 1.0, fract(at));
    return mix(mix(hash(cell), hash(cell + ivec2(1, 0)), f.x), mix(hash(cell + ivec2(0, 1)), hash(cell + 1), f.x), f.y);
}

float regolith_at(vec2 place) {
    ivec2 cell = clamp(origin_cell + ivec2(floor(place)), ivec2(0), patches - 1);
    vec2 w = clamp(place - vec2(cell - origin_cell), 0.0, 1.0);
    float a = mix(texelFetch(solid, cell, 0).b, texelFetch(solid, cell + ivec2(1, 0), 0).b, w.x);
    float b = mix(texelFetch(solid, cell + ivec2(0, 1), 0).b, texelFetch(solid, cell + 1, 0).b, w.x);
    return mix(a, b, w.y);
}

// Meadow, forest, rock, scree and snow by height, steepness and loose cover. Albedo, linear.
vec3 material(vec2 place, float share, float height_m, vec2 gradient, float scree_m) {
    float steep = length(gradient);
    vec2 absolute = place + vec2(origin_cell);
    float broad = smooth_hash(absolute * 0.11);
    float grain = 0.6 * smooth_hash(absolute * 0.45) + 0.4 * smooth_hash(absolute * 1.3 + 7.0);
    float level = share + 0.10 * (broad - 0.5) + 0.04 * (grain - 0.5);
    vec3 forest = mix(vec3(0.045, 0.068, 0.026), vec3(0.070, 0.092, 0.034), grain);
    vec3 meadow = mix(vec3(0.082, 0.105, 0.038), vec3(0.120, 0.128, 0.055), grain);
    vec3 heath = mix(vec3(0.155, 0.130, 0.075), vec3(0.190, 0.165, 0.105), grain);
    vec3 rock = mix(vec3(0.120, 0.108, 0.098), vec3(0.235, 0.222, 0.208), 0.35 * broad + 0.65 * grain);
    vec3 scree = mix(vec3(0.240, 0.215, 0.180), vec3(0.330, 0.300, 0.260), grain);
    vec3 cover = mix(meadow, forest, 0.6 * smoothstep(0.35, 0.65, broad + 0.25 * (grain - 0.5)) * (1.0 - smoothstep(0.30, 0.42, level)));
    cover = mix(cover, heath, smoothstep(0.34, 0.52, level));
    vec3 colour = mix(cover, rock, smoothstep(0.46, 0.80, steep + 0.45 * (level - 0.45) + 0.12 * (grain - 0.5)));
    colour = mix(colour, scree, 0.85 * (1.0 - exp(-max(scree_m, 0.0) / 2.5)));
    float snow = smoothstep(1250.0, 1450.0, height_m) * smoothstep(0.58, 0.70, level + 0.06 * normalize(vec3(-gradient, 1.0)).y) * (1.0 - smoothstep(0.62, 1.05, steep));
    return mix(colour, vec3(0.80, 0.83, 0.88), snow);
}

// The face that the terrain's rectangle is cut out by: layers of rock, fading out below.
vec3 cut_face(float above_eye, float lowest, float highest, vec3 backdrop, vec2 side) {
    float relief = max(highest - lowest, 1e-3 * extent_m);
    float depth = (above_eye - lowest) / relief;
    float bend = depth * 14.0 + 0.8 * smooth_hash(side * 0.02 + 3.0) + 0.3 * smooth_hash(side * 0.09);
    float layer = hash(ivec2(int(floor(bend)), 5));
    vec3 rock = mix(vec3(0.34, 0.31, 0.28), vec3(0.45, 0.41, 0.37), layer) * (0.93 + 0.07 * smoothstep(0.0, 0.15, fract(bend)));
    return mix(backdrop, rock, smoothstep(-0.42, -0.05, depth));
}

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

// Height over the datum where a pixel beside this one hit; the eye's where it hit nothing.
float height_beside(ivec2 pixel) {
    float distance_m = texelFetch(hits, clamp(pixel, ivec2(0), ivec2(picture_size) - 1), 0).r;
    vec2 at = vec2(2.0 * (vec2(pixel) + 0.5) / picture_size - 1.0);
    return origin_height_m.x + (isinf(distance_m) ? 0.0 : distance_m * pixel_ray(at).z);
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
    return ink;
}

// What the ground gained since the terrain was made.
float ground_change(vec2 place) {
    ivec2 cell = clamp(origin_cell + ivec2(floor(place)), ivec2(0), patches - 1);
    vec2 w = clamp(place - vec2(cell - origin_cell), 0.0, 1.0);
    vec4 change;
    for (int i = 0; i < 4; ++i) {
        ivec2 at = cell + ivec2(i & 1, i >> 1);
        vec2 before = texelFetch(start, at, 0).rg;
        change[i] = (texelFetch(ground, at, 0).r - before.x) - before.y;
    }
    return mix(mix(change.x, change.y, w.x), mix(change.z, change.w, w.x), w.y);
}

void main() {
    vec2 hit = texelFetch(hits, ivec2(gl_FragCoord.xy), 0).rg;
    vec3 ray = pixel_ray(picture_position());
    vec3 world_ray = vec3(ray.x * cell_m.x, -ray.y * cell_m.y, ray.z);
    bool missed = isinf(hit.x);
    if (view == 4) {
        colour_out = vec4(colour_map(hit.y / steps_scale), 1.0);
        return;
    }
    vec3 backdrop = view == 0 ? sqrt(sky(world_ray)) : vec3(0.16, 0.17, 0.19);
    if (missed) {
        colour_out = vec4(backdrop, 1.0);
        return;
    }
    vec2 place = origin_fraction + hit.x * ray.xy;
    float above_eye = hit.x * ray.z;
    float reach = clamp(hit.x * pixel_angle / min(cell_m.x, cell_m.y), 1.0, 12.0);
    vec2 gradient = gradient_at(place, view == 0 ? reach : 1.0);
    vec3 normal = normalize(vec3(-gradient, 1.0));
    float highest = load_highest();
    float lowest = (texelFetch(bottoms, whole_texel(), 0).r - origin_height_m.x) - origin_height_m.y;
    float share = (above_eye - lowest) / max(highest - lowest, 1e-3);
    vec3 colour;
    // The side that the terrain is cut out by: below the surface on the rectangle's edge, or from inside the ground.
    vec2 absolute = place + vec2(origin_cell);
    bool on_edge = hit.x == 0.0 || any(lessThan(absolute, vec2(2e-3))) || any(greaterThan(absolute, vec2(patches) - 2e-3));
    if (on_edge && above_eye < height_at(place) - 1e-3 * extent_m * 0.05 - 1e-4 * hit.x) {
        colour_out = vec4(cut_face(above_eye, lowest, highest, backdrop, absolute), 1.0);
        return;
    }
    if (view == 5) {
        colour_out = vec4(kind_map(hit.y) * (0.45 + 0.55 * max(dot(normal, sun), 0.0)), 1.0);
        return;
    }
    if (view == 1) {
        colour = vec3(hillshade_lights == 4 ? four_lights(gradient, normal) : max(dot(normal, sun), 0.0));
    } else if (view == 2) {
        colour = colour_map(atan(length(gradient)) * 180.0 / pi / slope_scale_deg) * (0.75 + 0.25 * normal.z);
    } else if (view == 3) {
        float height_m = origin_height_m.x + above_eye;
        float band = floor(height_m / band_m);
        float bottom_band = floor((lowest + origin_height_m.x) / band_m);
        float top_band = floor((highest + origin_height_m.x) / band_m);
        colour = colour_map((band - bottom_band) / max(top_band - bottom_band, 1.0)) * (0.55 + 0.45 * max(dot(normal, sun), 0.0));
    } else if (view == 6) {
        // Where the slope faces, clockwise from north; the flatter, the greyer.
        float facing = atan(-gradient.x, -gradient.y) / (2.0 * pi);
        colour = mix(vec3(0.6), direction_map(facing), smoothstep(0.0, 0.05, length(gradient))) * (0.55 + 0.45 * max(dot(normal, sun), 0.0));
    } else if (view == 7) {
        colour = vec3(0.93, 0.91, 0.86) * (0.55 + 0.45 * max(dot(normal, sun), 0.0));
        colour = mix(colour, vec3(0.36, 0.22, 0.12), contour_ink(hit.x, ray));
    } else if (view == 8) {
        float change = ground_change(place);
        colour = difference_map(0.5 + 0.5 * change / difference_m) * (0.55 + 0.45 * max(dot(normal, sun), 0.0));
    } else {
        vec3 albedo = material(place, share, origin_height_m.x + above_eye, gradient, regolith_at(place));
        float light = max(dot(normal, sun), 0.0);
        if (shadows != 0 && light > 0.0) {
            // From a little above the ground, towards the eye, so that a hill does not shade its own patch by rounding.
            float lift = 1e-3 * min(cell_m.x, cell_m.y) + 2e-5 * hit.x;
            vec2 from = place - ray.xy * lift;
            ivec2 from_cell = ivec2(floor(from));
            vec3 to_sun = vec3(sun.x / cell_m.x, -sun.y / cell_m.y, sun.z);
            CastHit shade = cast_ray(origin_cell + from_cell, from - vec2(from_cell), to_sun, 0.0, 5, above_eye + 2.0 * lift);
            if (shade.distance_m > lift) light = 0.0;
        }
        vec3 ambient = mix(vec3(0.16, 0.15, 0.13), vec3(0.36, 0.46, 0.62), 0.5 + 0.5 * normal.z);
        colour = albedo * (light * vec3(3.5, 3.2, 2.75) + 0.9 * ambient);
        float haze = 1.0 - exp(-0.16 * hit.x / extent_m);
        colour = mix(colour, sky(normalize(vec3(world_ray.xy, 0.06))), 0.85 * haze);
        colour = sqrt(clamp(colour, 0.0, 1.0));
    }
    colour_out = vec4(colour, 1.0);
}

// Colours what a method hit: position, filtered normal, material, sun, shadow, haze; or one of the views. VIEW is its number
// (render/view.h): software runs all branches of a shader, so each view is a program of its own.
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

uniform real3 sun;           // towards it: east, north, up
uniform real extent_m;       // of the terrain, sets the haze
uniform real pixel_angle;    // radians that a pixel covers
uniform real band_m;         // height bands: interval
uniform real slope_scale_deg;
uniform real steps_scale;
uniform real depth_scale_m;    // views of the water: ends of their scales
uniform real speed_scale;
uniform real level_middle_m;
uniform real level_scale_m;
uniform real froude_scale;
uniform real arrival_scale_s;
uniform real rain_scale;       // mm/h
uniform real suspended_scale_mm;
uniform real regolith_scale_m;
uniform real difference_m;   // view of the difference: end of its scale
uniform int hillshade_lights;  // 1: the sun; 4: from four sides

const float pi = 3.14159265;

const int view_shaded = 0;
const int view_hillshade = 1;
const int view_slope = 2;
const int view_bands = 3;
const int view_steps = 4;
const int view_cells = 5;
const int view_aspect = 6;
const int view_contours = 7;
const int view_difference = 8;
const int view_depth = 9;
const int view_speed = 10;
const int view_level = 11;
const int view_froude = 12;
const int view_largest = 13;
const int view_arrival = 14;
const int view_hardness = 15;
const int view_mask = 16;
const int view_rain = 17;
const int view_suspended = 18;
const int view_regolith = 19;

#include "render/relief.glsl"
#include "render/sky.glsl"
#include "render/cut_face.glsl"
#include "render/footprint.glsl"
#include "render/material.glsl"
#include "render/contours.glsl"
#include "render/occlusion.glsl"
// A layer at a place of the picture, between its four samples; `ghosts` samples lie around it.
vec4 layer_at(sampler2D layer, vec2 place, int ghosts) {
    ivec2 cell = clamp(origin_cell + ivec2(floor(place)), ivec2(0), patches - 1);
    vec2 w = clamp(place - vec2(cell - origin_cell), 0.0, 1.0);
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 4; ++i)
        sum += ((i & 1) == 0 ? 1.0 - w.x : w.x) * (i < 2 ? 1.0 - w.y : w.y) * texelFetch(layer, cell + ivec2(i & 1, i >> 1) + ghosts, 0);
    return sum;
}

#ifdef LOADED
layout(binding = 12) uniform sampler2D suspended;  // m, two words, two ghost samples around
#endif
#ifdef WATER
#include "render/flow.glsl"
layout(binding = 10) uniform sampler2D inundation;  // largest depth, arrival

// Streaks along the flow: noise smeared along it (line integral convolution, Cabral & Leedom 1993), about 1.
float streaks(vec2 place, vec2 velocity) {
    vec2 along = vec2(velocity.x, -velocity.y) / max(length(velocity), 1e-6);
    float sum = 0.0;
    for (int k = -10; k <= 10; ++k) sum += textureLod(grain, (place + 0.5 * float(k) * along) * (1.0 / 56.0), 0.0).z;
    return clamp(1.0 + 2.2 * (sum / 21.0 - 0.5), 0.6, 1.4);
}

// The inundation map between its samples, m and s: of those where water arrived.
vec2 inundation_at(vec2 place) {
    ivec2 cell = clamp(origin_cell + ivec2(floor(place)), ivec2(0), patches - 1);
    vec2 w = clamp(place - vec2(cell - origin_cell), 0.0, 1.0);
    vec2 sum = vec2(0.0);
    float weights = 0.0;
    for (int i = 0; i < 4; ++i) {
        vec2 texel = texelFetch(inundation, cell + ivec2(i & 1, i >> 1), 0).rg;
        float weight = ((i & 1) == 0 ? 1.0 - w.x : w.x) * (i < 2 ? 1.0 - w.y : w.y);
        sum.x += weight * texel.x;
        weight = texel.x > 0.0 ? weight : 0.0;
        sum.y += weight * texel.y;
        weights += weight;
    }
    return vec2(sum.x, sum.y / max(weights, 1e-6));
}

// What a view of the water shows at a place of the picture; dry ground is grey.
vec3 water_view(vec2 place, vec2 absolute, float height_over_eye, float lit) {
    if (VIEW == view_largest || VIEW == view_arrival) {
        vec2 flood = inundation_at(place);
        if (flood.x < seen_depth_m) return vec3(0.62) * lit;
        return colour_map(VIEW == view_largest ? flood.x / depth_scale_m : flood.y / arrival_scale_s);
    }
    Flow flow = flow_at(place);
    if (flow.depth_m < seen_depth_m) return vec3(0.62) * lit;
    float speed = length(flow.velocity);
    if (VIEW == view_depth) return colour_map(flow.depth_m / depth_scale_m);
    if (VIEW == view_speed) return colour_map(speed / speed_scale) * (speed > 1e-3 * speed_scale ? streaks(absolute, flow.velocity) : 1.0);
    if (VIEW == view_froude) return colour_map(speed / sqrt(9.81 * flow.depth_m) / froude_scale);
    float level = (height_over_eye + flow.depth_m) + (origin_height_m.x - level_middle_m);
    return difference_map(0.5 + 0.5 * level / level_scale_m);
}
#endif

#ifdef PAINTED
layout(binding = 11) uniform sampler2D painted;  // hardness, mask, rain

vec3 painted_view(vec2 place, float lit) {
    vec3 sum = layer_at(painted, place, 0).xyz;
    float share = VIEW == view_hardness ? sum.x : (VIEW == view_mask ? sum.y : sum.z / rain_scale);
    return (share > 0.0 ? colour_map(share) : vec3(0.62)) * lit;
}
#endif

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

// What of the sun's light comes here, past what stands between; 0 or 1.
float sunlight_at(vec2 place, vec3 ray, float above_eye, float distance_m) {
#ifdef SHADOWS
    // From a little above the ground, towards the eye, so that a hill does not shade its own patch by rounding.
    float lift = 1e-3 * min(cell_m.x, cell_m.y) + 2e-5 * distance_m;
    vec2 from = place - ray.xy * lift;
    ivec2 from_cell = ivec2(floor(from));
    vec3 to_sun = vec3(sun.x / cell_m.x, -sun.y / cell_m.y, sun.z);
    CastHit shade = cast_ray(origin_cell + from_cell, from - vec2(from_cell), to_sun, 0.0, 2, above_eye + 2.0 * lift);
    return shade.distance_m > lift ? 0.0 : 1.0;
#else
    return 1.0;
#endif
}

void main() {
    vec2 hit = texelFetch(hits, ivec2(gl_FragCoord.xy), 0).rg;
    vec2 at = picture_position();
    vec3 ray = pixel_ray(at);
    vec3 world_ray = vec3(ray.x * cell_m.x, -ray.y * cell_m.y, ray.z);
    bool missed = isinf(hit.x);
    if (VIEW == view_steps) {
        colour_out = vec4(colour_map(hit.y / steps_scale), 1.0);
        return;
    }
    vec3 backdrop = VIEW == view_shaded ? sqrt(sky(world_ray)) + dither(ivec2(gl_FragCoord.xy)) : vec3(0.16, 0.17, 0.19);
#ifdef SKY
    colour_out = vec4(backdrop, 1.0);
    return;
#endif
    float distance_m = missed ? 0.0 : hit.x;
    vec2 place = origin_fraction + distance_m * ray.xy;
    vec2 absolute = place + vec2(origin_cell);
    float above_eye = distance_m * ray.z;
    float height_m = origin_height_m.x + above_eye;
    float reach = VIEW == view_shaded ? clamp(distance_m * pixel_angle / min(cell_m.x, cell_m.y), 1.0, 12.0) : 1.0;
    Relief relief = relief_at(place, above_eye, reach);
    vec2 gradient = relief.gradient;
    vec3 normal = normalize(vec3(-gradient, 1.0));
    float highest = load_highest();
    float lowest = (texelFetch(bottoms, whole_texel(), 0).r - origin_height_m.x) - origin_height_m.y;
    float share = (above_eye - lowest) / max(highest - lowest, 1e-3);
    // The side that the terrain is cut out by: below the surface on the rectangle's edge, or from inside the ground.
    bool on_edge = hit.x == 0.0 || any(lessThan(absolute, vec2(2e-3))) || any(greaterThan(absolute, vec2(patches) - 2e-3));
    bool cut = on_edge && above_eye < height_at(place) - 1e-3 * extent_m * 0.05 - 1e-4 * distance_m;
    float lit = 0.55 + 0.45 * max(dot(normal, sun), 0.0);
    vec3 colour;
    if (VIEW == view_shaded) {
        Footprint footprint = footprint_of(ray_forward + at.x * ray_right + at.y * ray_up, normal, distance_m);
#ifdef DRAPED
        vec3 albedo = draped(absolute, footprint);
#else
        vec3 albedo = material(absolute, footprint, share, height_m, relief);
#endif
        float light = max(dot(normal, sun), 0.0);
        light *= light > 0.0 && !missed ? sunlight_at(place, ray, above_eye, distance_m) : 1.0;
        vec3 ambient = mix(vec3(0.16, 0.15, 0.13), vec3(0.36, 0.46, 0.62), 0.5 + 0.5 * normal.z) * sky_share_at(absolute);
        colour = albedo * (light * vec3(3.5, 3.2, 2.75) + 0.9 * ambient);
        float haze = 1.0 - exp(-0.16 * distance_m / extent_m);
        colour = mix(colour, sky(normalize(vec3(world_ray.xy, 0.06))), 0.85 * haze);
        // Bright snow keeps its shades: what exceeds the screen's range is drawn together towards white.
        colour *= (1.0 + colour / 6.25) / (1.0 + 0.45 * colour);
        colour = sqrt(clamp(colour, 0.0, 1.0));
    } else if (VIEW == view_hillshade) {
        colour = vec3(hillshade_lights == 4 ? four_lights(gradient, normal) : max(dot(normal, sun), 0.0));
    } else if (VIEW == view_slope) {
        colour = colour_map(atan(length(gradient)) * 180.0 / pi / slope_scale_deg) * (0.75 + 0.25 * normal.z);
    } else if (VIEW == view_bands) {
        float band = floor(height_m / band_m);
        float bottom_band = floor((lowest + origin_height_m.x) / band_m);
        float top_band = floor((highest + origin_height_m.x) / band_m);
        colour = colour_map((band - bottom_band) / max(top_band - bottom_band, 1.0)) * lit;
    } else if (VIEW == view_cells) {
        colour = kind_map(hit.y) * (0.45 + 0.55 * max(dot(normal, sun), 0.0));
    } else if (VIEW == view_aspect) {
        // Where the slope faces, clockwise from north; the flatter, the greyer.
        float facing = atan(-gradient.x, -gradient.y) / (2.0 * pi);
        colour = mix(vec3(0.6), direction_map(facing), smoothstep(0.0, 0.05, length(gradient))) * lit;
    } else if (VIEW == view_contours) {
        colour = mix(vec3(0.93, 0.91, 0.86) * lit, vec3(0.36, 0.22, 0.12), contour_ink(distance_m, ray));
    } else if (VIEW == view_regolith) {
        vec2 depth = layer_at(solid, place, 0).zw;
        colour = depth.x > 0.0 ? colour_map((depth.x + depth.y) / regolith_scale_m) * lit : vec3(0.62) * lit;
    } else if (VIEW == view_suspended) {
#ifdef LOADED
        float mm = 1e3 * layer_at(suspended, place, 2).x;
        colour = mm > 1e-3 * suspended_scale_mm ? colour_map(mm / suspended_scale_mm) : vec3(0.62) * lit;
#else
        colour = vec3(0.62) * lit;
#endif
    } else if (VIEW >= view_hardness) {
#ifdef PAINTED
        colour = painted_view(place, lit);
#else
        colour = vec3(0.62) * lit;
#endif
    } else if (VIEW >= view_depth) {
#ifdef WATER
        colour = water_view(place, absolute, height_at(place), lit);
#else
        colour = vec3(0.62) * lit;
#endif
    } else {
        colour = difference_map(0.5 + 0.5 * ground_change(place) / difference_m) * lit;
    }
    colour = cut ? cut_face(above_eye, lowest, highest, backdrop, absolute) : colour;
    colour_out = vec4(missed ? backdrop : colour, 1.0);
}

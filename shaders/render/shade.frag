// Colours what a method hit: position, filtered normal, material, sun, shadow, haze; or one of the views.
const bool count_steps = false;
#include "render/surface.glsl"
#include "render/picture.glsl"
#include "maths/cast.glsl"
#include "maths/colour_map.glsl"

layout(location = 0) out vec4 colour_out;

layout(binding = 2) uniform sampler2D bottoms;
layout(binding = 3) uniform sampler2D regolith;
layout(binding = 4) uniform sampler2D hits;

uniform int view;            // as in render/view.h
uniform real3 sun;           // towards it: east, north, up
uniform int shadows;
uniform real extent_m;       // of the terrain, sets the haze
uniform real pixel_angle;    // radians that a pixel covers
uniform real band_m;         // height bands: interval
uniform real slope_scale_deg;
uniform real steps_scale;
uniform real3 ring_m;        // brush ring: x, y over the eye's, radius; radius 0: none

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

// Meadow, forest, rock, scree and snow by height, steepness and loose cover.
vec3 material(vec2 place, float share, vec2 gradient, float scree_m) {
    float steep = length(gradient);
    ivec2 cell = origin_cell + ivec2(floor(place));
    vec2 f = smoothstep(0.0, 1.0, fract(place));
    float grain = mix(mix(hash(cell), hash(cell + ivec2(1, 0)), f.x), mix(hash(cell + ivec2(0, 1)), hash(cell + 1), f.x), f.y);
    float rough_share = share + 0.05 * (grain - 0.5);
    vec3 green = mix(vec3(0.125, 0.185, 0.070), vec3(0.235, 0.265, 0.105), smoothstep(0.1, 0.5, rough_share));
    vec3 heath = vec3(0.33, 0.30, 0.18);
    vec3 rock = mix(vec3(0.27, 0.245, 0.22), vec3(0.37, 0.355, 0.335), smoothstep(0.3, 0.9, rough_share)) * (0.88 + 0.24 * grain);
    vec3 ground_colour = mix(green, heath, smoothstep(0.35, 0.62, rough_share));
    ground_colour = mix(ground_colour, rock, smoothstep(0.42, 0.78, steep + 0.25 * (rough_share - 0.5)));
    ground_colour = mix(ground_colour, vec3(0.50, 0.455, 0.39) * (0.86 + 0.28 * grain), smoothstep(0.05, 1.5, scree_m) * 0.9);
    float snow = smoothstep(0.66, 0.80, rough_share) * (1.0 - smoothstep(0.65, 1.15, steep));
    return mix(ground_colour, vec3(0.86, 0.89, 0.93), snow);
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
    if (missed) {
        colour_out = vec4(view == 0 ? sqrt(sky(world_ray)) : vec3(0.16, 0.17, 0.19), 1.0);
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
    if (view == 1) {
        colour = vec3(max(dot(normal, sun), 0.0));
    } else if (view == 2) {
        colour = colour_map(atan(length(gradient)) * 180.0 / pi / slope_scale_deg) * (0.75 + 0.25 * normal.z);
    } else if (view == 3) {
        float height_m = origin_height_m.x + above_eye;
        float band = floor(height_m / band_m);
        float bottom_band = floor((lowest + origin_height_m.x) / band_m);
        float top_band = floor((highest + origin_height_m.x) / band_m);
        colour = colour_map((band - bottom_band) / max(top_band - bottom_band, 1.0)) * (0.55 + 0.45 * max(dot(normal, sun), 0.0));
    } else {
        ivec2 cell = clamp(origin_cell + ivec2(floor(place + 0.5)), ivec2(0), patches);
        vec3 albedo = material(place, share, gradient, texelFetch(regolith, cell, 0).r);
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
        vec3 ambient = mix(vec3(0.30, 0.28, 0.25), vec3(0.46, 0.56, 0.72), 0.5 + 0.5 * normal.z) * (0.45 + 0.55 * normal.z);
        colour = albedo * (light * vec3(2.45, 2.25, 1.95) + 0.85 * ambient);
        float haze = 1.0 - exp(-0.35 * hit.x / extent_m);
        colour = mix(colour, sky(normalize(vec3(world_ray.xy, 0.06))), haze * 0.75);
        colour = sqrt(clamp(colour, 0.0, 1.0));
    }
    if (ring_m.z > 0.0) {
        vec2 from_eye = vec2(hit.x * world_ray.x, hit.x * world_ray.y);
        float off = abs(length(from_eye - ring_m.xy) - ring_m.z);
        float line = 1.2 * hit.x * pixel_angle / max(abs(dot(normal, world_ray)), 0.15);
        colour = mix(colour, vec3(1.0, 0.78, 0.2), 1.0 - smoothstep(line, 2.0 * line, off));
        float centre = length(from_eye - ring_m.xy);
        colour = mix(colour, vec3(1.0, 0.78, 0.2), 1.0 - smoothstep(1.5 * line, 2.5 * line, centre));
    }
    colour_out = vec4(colour, 1.0);
}

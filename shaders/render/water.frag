// Water over the picture of the ground: what the eye sees of the bed through it, and what it reflects.
const bool count_steps = false;
#include "render/picture.glsl"
#include "render/whole_ground.glsl"

layout(location = 0) out vec4 colour_out;

uniform sampler2D level;
uniform sampler2D hits;
uniform sampler2D water_hits;
uniform sampler2D colours;

uniform real3 sun;  // towards it: east, north, up
uniform real extent_m;
uniform real gravity;  // m/s²

#include "render/relief.glsl"
#include "render/sky.glsl"
#include "render/flow.glsl"
#include "render/film.glsl"

uniform float water_kind;     // of a mountain, the sea, a lagoon, muddy
uniform float water_clarity;  // times as far as in nature

// Clear water takes red first, 1/m (after Pope & Fry 1997, with what it carries); what it scatters back.
const vec3 absorptions[4] = vec3[4](vec3(0.42, 0.085, 0.060), vec3(0.36, 0.070, 0.025), vec3(0.30, 0.040, 0.035), vec3(0.70, 0.95, 1.40));
const vec3 deeps[4] = vec3[4](vec3(0.012, 0.060, 0.075), vec3(0.006, 0.035, 0.095), vec3(0.015, 0.150, 0.160), vec3(0.150, 0.105, 0.055));
const float refractive_index = 1.333;

// Level over the eye.
float level_at(vec2 place) {
    ivec2 cell = clamp(origin_cell + ivec2(floor(place)), ivec2(0), patches - 1);
    vec2 w = clamp(place - vec2(cell - origin_cell), 0.0, 1.0);
    vec4 z = textureGather(level, vec2(cell + 1) / vec2(patches + 1)).wzxy;
    return (patch_height(z - origin_height_m.x, w)) - origin_height_m.y;
}

// Slope of the level to east and north; towards the shore it goes by the samples that are there.
vec2 level_gradient(vec2 place, float here, float reach) {
    vec2 gradient;
    for (int axis = 0; axis < 2; ++axis) {
        vec2 step = axis == 0 ? vec2(reach, 0.0) : vec2(0.0, reach);
        float spacing = reach * (axis == 0 ? cell_m.x : cell_m.y);
        float before = level_at(place - step);
        float behind = level_at(place + step);
        // Where the level dives below dry ground there is no slope to see.
        float limit = 0.6 * spacing;
        float a = abs(here - before) < limit ? here - before : 0.0;
        float b = abs(behind - here) < limit ? behind - here : 0.0;
        gradient[axis] = (a + b) / (2.0 * spacing);
    }
    return vec2(gradient.x, -gradient.y);
}

// Light that the ground sends into a direction in which it was hit, roughly: for reflections.
vec3 reflected_ground(vec2 place, float above_eye) {
    Relief relief = relief_at(place, above_eye, 2.0);
    vec3 normal = normalize(vec3(-relief.gradient, 1.0));
    float lowest = load_lowest();
    float share = (above_eye - lowest) / max(load_highest() - lowest, 1e-3);
    vec3 albedo = mix(vec3(0.07, 0.09, 0.035), vec3(0.17, 0.155, 0.14), smoothstep(0.25, 0.6, share + 0.4 * length(relief.gradient) - 0.2));
    return albedo * (max(dot(normal, sun), 0.0) * vec3(3.5, 3.2, 2.75) + vec3(0.30, 0.36, 0.46));
}

#ifdef DRY
void main() { colour_out = vec4(texelFetch(colours, ivec2(gl_FragCoord.xy), 0).rgb, 1.0); }
#else
void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 ground_colour = texelFetch(colours, pixel, 0).rgb;
    float ground_m = texelFetch(hits, pixel, 0).r;
    float distance_m = texelFetch(water_hits, pixel, 0).r;
    colour_out = vec4(ground_colour, 1.0);
    if (isinf(distance_m) || distance_m >= ground_m) return;

    vec2 at = picture_position();
    vec3 ray = pixel_ray(at);
    vec3 world_ray = vec3(ray.x * cell_m.x, -ray.y * cell_m.y, ray.z);
    vec3 start = pixel_start(at);
    vec2 place = origin_fraction + start.xy + distance_m * ray.xy;
    float above_eye = start.z + distance_m * ray.z;
    float surface = level_at(place);
    float depth = max(surface - height_at(place), 0.0);
    // Through the side that the map is cut out by, or from below, the eye looks straight in.
    bool through_side = above_eye < surface - 1e-3 - 1e-5 * distance_m;
    float reach = clamp(pixel_m_at(distance_m) / min(cell_m.x, cell_m.y), 1.0, 12.0);
    vec2 slope = level_gradient(place, surface, reach);
    vec3 normal = normalize(vec3(-slope, 1.0));
    if (dot(normal, world_ray) > -0.02) normal = normalize(normal - world_ray * (dot(normal, world_ray) + 0.02));

    // The bed where the refracted ray meets it, as far as the picture shows it.
    vec3 into = refract(world_ray, normal, 1.0 / refractive_index);
    if (through_side) into = world_ray;
    float way_m = through_side ? min(ground_m, distance_m + extent_m) - distance_m : depth / max(-into.z, 0.2);
    vec3 bed = ground_colour;
    if (!through_side) {
        vec3 clip = clip_of(pixel_start_m(at) + world_ray * distance_m + into * way_m);
        ivec2 seen = ivec2(floor((0.5 + 0.5 * clip.xy / max(clip.z, 1e-6)) * picture_size));
        if (clip.z > 0.0 && all(greaterThanEqual(seen, ivec2(0))) && all(lessThan(vec2(seen), picture_size)) &&
            texelFetch(hits, seen, 0).r > texelFetch(water_hits, seen, 0).r)
            bed = texelFetch(colours, seen, 0).rgb;
    }
    bed *= bed;  // pictures hold square roots of light
    float light = 0.35 + 0.65 * max(dot(normal, sun), 0.0);
    int kind = int(water_kind + 0.5);
    vec3 left = exp(-absorptions[kind] * ((way_m + 0.6 * depth) / water_clarity));
    vec3 body = bed * left + deeps[kind] * light * (1.0 - exp(-0.16 * way_m / water_clarity));

    // What it mirrors: sky, or terrain that stands before it. Schlick 1994.
    float facing = clamp(-dot(world_ray, normal), 0.0, 1.0);
    float fresnel = through_side ? 0.0 : 0.02 + 0.98 * pow(1.0 - facing, 5.0);
    // Glitter: ripples too small for the samples, of a light breeze's slopes (Cox & Munk 1954), each mirroring the sun.
    const float slopes = 0.018;
    vec3 half_way = normalize(sun - world_ray);
    vec2 tilt = half_way.xy / max(half_way.z, 0.05) + slope;
    float glitter = exp(-dot(tilt, tilt) / slopes) / (3.14159 * slopes) * (0.02 + 0.98 * pow(1.0 - max(dot(half_way, -world_ray), 0.0), 5.0)) / max(4.0 * facing, 0.4);
    vec3 mirror = reflect(world_ray, normal);
    mirror.z = max(mirror.z, 0.01);
    vec3 reflection = sky(normalize(mirror));
    float lift = 1e-3 * min(cell_m.x, cell_m.y) + 2e-5 * distance_m + 0.02;
#ifdef MIRRORS_GROUND
    CastHit ahead = cast_ray(origin_cell + ivec2(floor(place)), place - floor(place), vec3(mirror.x / cell_m.x, -mirror.y / cell_m.y, mirror.z), 0.0, 2, above_eye + lift);
    if (ahead.distance_m > lift) {
        vec2 there = place + ahead.distance_m * vec2(mirror.x / cell_m.x, -mirror.y / cell_m.y);
        reflection = reflected_ground(there, above_eye + ahead.distance_m * mirror.z);
    }
#endif
    vec3 colour = mix(body, reflection, fresnel);
    if (!through_side) colour += 3.0 * min(glitter, 1.0) * vec3(1.0, 0.92, 0.78) * max(sun.z, 0.0);
    // White water where it shoots (Froude number above 1) down a slope of its own, deep enough to break, and on the steep
    // front of a wave that runs.
    Flow flow = flow_at(place);
    float froude = length(flow.velocity) / sqrt(gravity * max(flow.depth_m, wet_depth_m));
    float foam = smoothstep(0.9, 1.8, froude) * smoothstep(0.05, 0.4, flow.depth_m) * smoothstep(0.03, 0.25, length(slope));
    float front = smoothstep(0.08, 0.25, length(slope)) * smoothstep(0.12, 0.35, froude) * smoothstep(0.3, 1.5, flow.depth_m);
    if (!through_side) colour = mix(colour, vec3(0.75, 0.80, 0.83) * light, 0.75 * max(foam, front));
    // The bed has its haze already.
    float haze = haze_at(distance_m);
    colour = mix(colour, sky(normalize(vec3(world_ray.xy, 0.06))), 0.85 * haze * (through_side ? 0.5 : 1.0));
    // Towards the shore it fades into the ground, a film wholly; so do sheets that run down steep ground.
    float body_share = (1.0 - exp(-depth / (min(0.08, 0.08 * water_clarity) + 0.5 * length(slope)))) * smoothstep(film_m.x, film_m.y, depth);
    colour = mix(bed, colour, through_side ? 1.0 : body_share);
    colour_out = vec4(sqrt(clamp(colour, 0.0, 1.0)), 1.0);
}
#endif

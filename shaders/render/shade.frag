// Colours what a method hit, by the view's own file: shaders/render/views, one for each (render/view.h). Software runs all
// branches of a shader, so each view is a program of its own; VIEW_FILE names its file, GROUND_FILE the one of the ground:
// whole_ground.glsl or tile_ground.glsl.
const bool count_steps = false;
#include "render/picture.glsl"
#include GROUND_FILE
#include "maths/colour_map.glsl"

layout(location = 0) out vec4 colour_out;

uniform sampler2D solid;  // bedrock, its low word, regolith, its low word
uniform sampler2D hits;
uniform sampler2D start;  // the ground when the terrain was made, two words

uniform real3 sun;         // towards it: east, north, up
uniform real extent_m;     // of the terrain, sets the haze

#ifdef BESIDE
// Of all that stands in the picture, this ground and the other: lowest and highest, m, and where among the other's columns and
// rows this one's first is, so that materials go on from one to the other.
uniform real2 beside_range_m;
uniform real2 beside_first;
uniform sampler2D beside_shadow;  // 1 where the other one shades a pixel's hit

vec2 material_place(vec2 absolute) { return absolute + beside_first; }
#else
vec2 material_place(vec2 absolute) { return absolute; }
#endif

#include "render/relief.glsl"
#include "render/sky.glsl"
#include "render/cut_face.glsl"
#include "render/footprint.glsl"
#include "render/material.glsl"
#ifdef PHOTO
#include "render/photo.glsl"
#endif
#include "render/occlusion.glsl"

#include "render/view_point.glsl"
#include VIEW_FILE

// Whether it is a wall of the hole that another ground stands in (tiled.frag).
#ifdef HOLE
bool on_wall(vec2 hit) { return hit.y < 0.0; }
#else
bool on_wall(vec2 hit) { return false; }
#endif

void main() {
    ViewPoint point;
    point.hit = texelFetch(hits, ivec2(gl_FragCoord.xy), 0).rg;
#ifdef SKY_TOO
    colour_out = vec4(view_colour(point), 1.0);
    return;
#endif
    point.at = picture_position();
    point.ray = pixel_ray(point.at);
    point.world_ray = vec3(point.ray.x * cell_m.x, -point.ray.y * cell_m.y, point.ray.z);
    point.missed = isinf(point.hit.x);
#ifdef NATURAL
    vec3 backdrop = sqrt(sky(point.world_ray)) + dither(ivec2(gl_FragCoord.xy));
#else
    vec3 backdrop = vec3(0.16, 0.17, 0.19);
#endif
#ifdef SKY
#ifndef HOLE
    colour_out = vec4(backdrop, 1.0);
    return;
#endif
#endif
    point.distance_m = point.missed ? 0.0 : point.hit.x;
    vec3 start = pixel_start(point.at);
    point.place = origin_fraction + start.xy + point.distance_m * point.ray.xy;
    point.absolute = point.place + vec2(origin_cell);
    point.above_eye_m = start.z + point.distance_m * point.ray.z;
    point.height_m = origin_height_m.x + point.above_eye_m;
#ifdef BESIDE
    point.lowest_m = (beside_range_m.x - origin_height_m.x) - origin_height_m.y;
    point.highest_m = (beside_range_m.y - origin_height_m.x) - origin_height_m.y;
#else
    point.highest_m = load_highest();
    point.lowest_m = load_lowest();
#endif
#ifdef SKY
    // Or the wall of the hole.
    vec3 wall = cut_face(point.above_eye_m, point.lowest_m, point.highest_m, backdrop, material_place(point.absolute));
    colour_out = vec4(point.missed ? backdrop : wall, 1.0);
    return;
#endif
    vec2 relief_place = relief_place_of(point.place, point.hit.y);
#ifdef NATURAL
    float reach = clamp(pixel_m_at(point.distance_m) / min(relief_cell_m().x, relief_cell_m().y), 1.0, 12.0);
#else
    float reach = 1.0;
#endif
    point.relief = relief_at(relief_place, point.above_eye_m, reach);
    point.normal = normalize(vec3(-point.relief.gradient, 1.0));
    point.share = (point.above_eye_m - point.lowest_m) / max(point.highest_m - point.lowest_m, 1e-3);
    point.lit = 0.55 + 0.45 * max(dot(point.normal, sun), 0.0);
    // The terrain's cut side: below the surface on the rectangle's edge, or seen from inside the ground.
    // How far from the edge a place on it may be found, in patches: a float holds fewer of their parts the farther it is.
    vec2 edge = 2e-3 + 5e-7 * (abs(point.place) + vec2(patches));
    bool on_edge = point.hit.x == 0.0 || on_wall(point.hit) || any(lessThan(point.absolute, edge)) || any(greaterThan(point.absolute, vec2(patches) - edge));
    bool cut = on_edge && point.above_eye_m < height_at(relief_place) - 1e-3 * extent_m * 0.05 - 1e-4 * point.distance_m;
#ifdef ABSENT
    vec3 colour = bare * point.lit;
#else
    vec3 colour = view_colour(point);
#endif
    colour = cut ? cut_face(point.above_eye_m, point.lowest_m, point.highest_m, backdrop, point.absolute) : colour;
    colour_out = vec4(point.missed ? backdrop : colour, 1.0);
}

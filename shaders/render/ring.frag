// The picture with the brush's ring and its middle on the ground; with STAMP, the stamp as it would be pressed there.
#include "maths/glsl_types.glsl"
#include "render/picture.glsl"

layout(location = 0) out vec4 colour_out;

uniform sampler2D hits;
uniform sampler2D picture_colour;

#ifdef STAMP
uniform sampler2D stamp;
uniform vec2 stamp_columns;  // of the stamp, a metre east and north, from its middle
uniform vec2 stamp_rows;
#endif

uniform real line_px;     // that the ring's line covers
uniform real3 ring_m;     // x, y over the eye's, radius
uniform vec4 border_m;    // west, south, east and north border over the eye's; beyond are the terrain's sides, which no brush reaches

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float distance_m = texelFetch(hits, pixel, 0).r;
    vec2 at = picture_position();
    vec3 way = normalize(ray_forward + at.x * ray_right + at.y * ray_up);
    vec2 start = pixel_start_m(at).xy;
    vec2 aside = start + distance_m * way.xy - ring_m.xy;
    float from_middle = length(aside);
    // Lines lie on the ground: the flatter the ray, the longer they are for the eye.
    float line = line_px * pixel_m_at(distance_m) / max(abs(way.z), 0.15);
#ifdef STAMP
    vec2 last = vec2(textureSize(stamp, 0) - 1);
    vec2 sample_at = vec2(dot(aside, stamp_columns), dot(aside, stamp_rows)) + 0.5 * last;
    // Metres to the nearest edge, above 0 within.
    vec2 metres = 1.0 / vec2(length(stamp_columns), length(stamp_rows));
    vec2 within = min(sample_at, last - sample_at) * metres;
    float inside = min(within.x, within.y);
    // Its heights as light and dark, by their levels.
    float height = texelFetch(stamp, ivec2(clamp(sample_at + 0.5, vec2(0), last)), 0).r;
    float shown = inside > 0.0 ? 0.15 + 0.55 * floor(height * 10.0) / 10.0 : 0.0;
    float ring = max(shown, 1.0 - smoothstep(line, 2.0 * line, abs(inside)));
#else
    float ring = 1.0 - smoothstep(line, 2.0 * line, abs(from_middle - ring_m.z));
#endif
    float centre = 1.0 - smoothstep(1.5 * line, 2.5 * line, from_middle);
    vec4 colour = texelFetch(picture_colour, pixel, 0);
    vec2 place = start + distance_m * way.xy;
    float rounding_m = 4e-7 * (distance_m + length(start));  // a float has 24 bits: a few units in the last place
    bool ground = !isinf(distance_m) && all(greaterThan(place, border_m.xy + rounding_m)) && all(lessThan(place, border_m.zw - rounding_m));
    colour_out = ground ? mix(colour, vec4(1.0, 0.78, 0.2, 1.0), max(ring, centre)) : colour;
}

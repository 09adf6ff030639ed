// The picture with a rectangle's edge on the ground, and a breath of its colour within.
#include "maths/glsl_types.glsl"
#include "render/picture.glsl"

layout(location = 0) out vec4 colour_out;

uniform sampler2D hits;
uniform sampler2D picture_colour;

uniform real line_px;    // that the line covers
uniform vec4 edges_m;     // west, south, east and north edge over the eye's
uniform vec4 border_m;    // the same of the border beyond which the terrain's sides are, which are not drawn on

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 colour = texelFetch(picture_colour, pixel, 0);
    float distance_m = texelFetch(hits, pixel, 0).r;
    vec2 at = picture_position();
    vec3 way = normalize(ray_forward + at.x * ray_right + at.y * ray_up);
    vec2 start = pixel_start_m(at).xy;
    vec2 place = isinf(distance_m) ? vec2(1e30) : start + distance_m * way.xy;
    float rounding_m = 4e-7 * (distance_m + length(start));  // a float has 24 bits: a few units in the last place
    bool ground = all(greaterThan(place, border_m.xy + rounding_m)) && all(lessThan(place, border_m.zw - rounding_m));
    // Metres beyond the edges, below 0 within.
    vec2 beyond = max(edges_m.xy - place, place - edges_m.zw);
    float aside = length(max(beyond, 0.0)) + min(max(beyond.x, beyond.y), 0.0);
    // Lines lie on the ground: the flatter the ray, the longer they are for the eye.
    float line = line_px * pixel_m_at(distance_m) / max(abs(way.z), 0.15);
    float shown = max(1.0 - smoothstep(line, 2.0 * line, abs(aside)), aside < 0.0 ? 0.07 : 0.0);
    colour_out = ground ? mix(colour, vec4(1.0, 0.78, 0.2, 1.0), shown) : colour;
}

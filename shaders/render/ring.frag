// The picture with the brush's ring and its middle on the ground.
#include "maths/glsl_types.glsl"
#include "render/picture.glsl"

layout(location = 0) out vec4 colour_out;

layout(binding = 4) uniform sampler2D hits;
layout(binding = 5) uniform sampler2D picture_colour;

uniform real ring_angle;  // radians that the ring's line covers
uniform real3 ring_m;     // x, y over the eye's, radius

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float distance_m = texelFetch(hits, pixel, 0).r;
    vec2 at = picture_position();
    vec3 way = normalize(ray_forward + at.x * ray_right + at.y * ray_up);
    float from_middle = length(distance_m * way.xy - ring_m.xy);
    // Lines lie on the ground: the flatter the ray, the longer they are for the eye.
    float line = distance_m * ring_angle / max(abs(way.z), 0.15);
    float ring = 1.0 - smoothstep(line, 2.0 * line, abs(from_middle - ring_m.z));
    float centre = 1.0 - smoothstep(1.5 * line, 2.5 * line, from_middle);
    vec4 colour = texelFetch(picture_colour, pixel, 0);
    bool ground = !isinf(distance_m);
    colour_out = ground ? mix(colour, vec4(1.0, 0.78, 0.2, 1.0), max(ring, centre)) : colour;
}

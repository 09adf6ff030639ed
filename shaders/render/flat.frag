// Where beams found nothing but flat ground, or none: their height tells the hit.
#include "render/picture.glsl"
#include "render/beam_pixels.glsl"

layout(location = 0) out vec2 hit_out;
uniform sampler2D beams;

void main() {
    real2 beam = texelFetch(beams, ivec2(gl_FragCoord.xy) / beam_pixels, 0).rg;
    real3 ray = pixel_ray(picture_position());
    bool flat_end = beam.y < 0.0;
    hit_out = vec2(flat_end ? beam.x / ray.z : uintBitsToFloat(0x7f800000u), 0.0);
#ifdef TELL_KIND
    hit_out.y = flat_end ? 2.0 - beam.y : 0.0;
#endif
}

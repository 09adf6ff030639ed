// Marks the blocks whose beams end in flat cells otherwise than before.
layout(local_size_x = 16, local_size_y = 16) in;
#include "maths/glsl_types.glsl"
#include "render/redraw_marks.glsl"
#include "render/beam_pixels.glsl"

uniform sampler2D beams_now;
uniform sampler2D beams_before;

uniform int2 beam_count;

void main() {
    int2 at = int2(gl_GlobalInvocationID.xy);
    if (at.x >= beam_count.x || at.y >= beam_count.y) return;
    real2 now = texelFetch(beams_now, at, 0).rg;
    real2 before = texelFetch(beams_before, at, 0).rg;
    // A negative level says flat.
    if ((now.y < 0.0 || before.y < 0.0) && now != before) {
        // With the pixels around it, whose contour lines look at these.
        int2 first = max(at * beam_pixels - 1, int2(0)) / block_pixels;
        int2 last = min(((at + 1) * beam_pixels) / block_pixels, blocks - 1);
        for (int y = first.y; y <= last.y; ++y)
            for (int x = first.x; x <= last.x; ++x) redraw_marks[y * blocks.x + x] = 1u;
    }
}

// Marks the blocks of a picture in which the shadow of one ground on the other changed (render/tiled/backdrop.h).
layout(local_size_x = 16, local_size_y = 16) in;
#include "maths/glsl_types.glsl"
#include "render/redraw_marks.glsl"

uniform sampler2D shadow_now;
uniform sampler2D shadow_before;

uniform int2 size;  // of the picture

void main() {
    int2 at = int2(gl_GlobalInvocationID.xy);
    if (at.x >= size.x || at.y >= size.y) return;
    if (texelFetch(shadow_now, at, 0).r == texelFetch(shadow_before, at, 0).r) return;
    int2 block = at / block_pixels;
    redraw_marks[block.y * blocks.x + block.x] = 1u;
}

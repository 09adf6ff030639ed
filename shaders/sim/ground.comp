// Ground heights from the layers, after an import, an undo or a reload; every tile counts as changed.
layout(local_size_x = 16, local_size_y = 16) in;
#include "sim/samples.glsl"
#include "maths/solid.glsl"

uniform int2 first_sample;

void main() {
    int2 at = first_sample + int2(gl_GlobalInvocationID.xy);
    if (at.x >= samples.x || at.y >= samples.y) return;
    imageStore(ground_out, at, vec4(ground_height(load_solid(at))));
    mark_tile(at);
}

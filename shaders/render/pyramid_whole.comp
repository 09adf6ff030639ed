// The highest and lowest sample of the whole terrain, from the coarsest level.
layout(local_size_x = 64) in;
#include "render/pyramid_layout.glsl"

layout(binding = 0, r32f) uniform image2D highest;
layout(binding = 1, r32f) uniform image2D lowest;

uniform int level;

shared real tops[64];
shared real bottoms[64];

void main() {
    int2 size = level_1_size >> (level - 1);
    int me = int(gl_LocalInvocationIndex);
    real top = uintBitsToFloat(0xff800000u);
    real bottom = uintBitsToFloat(0x7f800000u);
    for (int i = me; i < size.x * size.y; i += 64) {
        int2 at = pyramid_texel(int2(i % size.x, i / size.x), level);
        top = max(top, imageLoad(highest, at).r);
        bottom = min(bottom, imageLoad(lowest, at).r);
    }
    tops[me] = top;
    bottoms[me] = bottom;
    barrier();
    if (me == 0) {
        for (int i = 1; i < 64; ++i) {
            top = max(top, tops[i]);
            bottom = min(bottom, bottoms[i]);
        }
        imageStore(highest, whole_texel(), vec4(top));
        imageStore(lowest, whole_texel(), vec4(bottom));
    }
}

// What this device makes of + × ÷ and √, to be compared with IEEE 754.
layout(local_size_x = 64) in;
#include "maths/glsl_types.glsl"

layout(rgba32f) uniform readonly image2D operands;
layout(rgba32f) uniform writeonly image2D results;   // sum, product, quotient, square root
layout(rgba32f) uniform writeonly image2D chained;   // product and sum in one expression

void main() {
    int2 at = int2(gl_GlobalInvocationID.xy);
    real4 x = imageLoad(operands, at);
    precise real sum = x.x + x.y;
    precise real product = x.x * x.y;
    precise real quotient = x.x / x.y;
    precise real root = sqrt(x.z);
    precise real both = x.x * x.y + x.w;
    imageStore(results, at, real4(sum, product, quotient, root));
    imageStore(chained, at, real4(both, 0.0, 0.0, 0.0));
}

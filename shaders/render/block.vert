// A listed block of the picture as a point: a square without the diagonal of two triangles, along which software would
// shade twice.
#include "maths/glsl_types.glsl"
#include "render/block_pixels.glsl"

layout(std430) readonly buffer BlockList { uint block_words[]; };

uniform int2 blocks;
uniform int first_word;  // of the list's numbers

void main() {
    uint number = block_words[first_word + gl_VertexID];
    int2 large_blocks = (blocks + large_block - 1) / large_block;
    bool large = (number & large_bit) != 0u;
    int index = int(number & ~large_bit);
    int columns = large ? large_blocks.x : blocks.x;
    int side = large ? large_block : 1;
    real2 middle = real(side) * (real2(index % columns, index / columns) + 0.5);
    gl_Position = vec4(2.0 * middle / real2(large_blocks * large_block) - 1.0, 0.0, 1.0);
    gl_PointSize = float(side * block_pixels);
}

// A listed block of the picture as two triangles.
#include "maths/glsl_types.glsl"
#include "render/camera.glsl"

layout(binding = 6, std430) readonly buffer Blocks { uint block_arguments[4]; uint listed_blocks[]; };

uniform int2 blocks;

const int block_pixels = 32;  // as in redraw_marks.glsl

void main() {
    int index = int(listed_blocks[gl_InstanceID]);
    int corner = gl_VertexID < 3 ? gl_VertexID : 6 - gl_VertexID;  // 0 1 2, 3 2 1
    int2 pixel = (int2(index % blocks.x, index / blocks.x) + int2(corner & 1, corner >> 1)) * block_pixels;
    gl_Position = vec4(2.0 * real2(pixel) / picture_size - 1.0, 0.0, 1.0);
}

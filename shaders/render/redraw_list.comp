// Lists the marked blocks: points of an indirect draw.
layout(local_size_x = 64) in;
#include "maths/glsl_types.glsl"
#include "render/redraw_marks.glsl"

layout(std430) buffer Blocks { uint block_arguments[4]; uint listed_blocks[]; };

void main() {
    int index = int(gl_GlobalInvocationID.x);
    if (index >= blocks.x * blocks.y || (redraw_all == 0u && redraw_marks[index] == 0u)) return;
    listed_blocks[atomicAdd(block_arguments[0], 1u)] = uint(index);
}

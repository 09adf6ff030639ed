// Lists the cells that the view may show: the instances of the mesh's indirect draw.
layout(local_size_x = 64) in;
#include "render/surface.glsl"
#include "render/camera.glsl"
#include "render/cell_box.glsl"

layout(std430) buffer MeshCells { uint draw_arguments[8]; uint mesh_cells[]; };

uniform int cell_level;

void main() {
    int2 size = level_1_size >> (cell_level - 1);
    int index = int(gl_GlobalInvocationID.x);
    if (index >= size.x * size.y) return;
    int2 cell = int2(index % size.x, index / size.x);
    int2 first = cell << cell_level;
    if (first.x >= patches.x || first.y >= patches.y || !box_in_view(cell_box(cell, cell_level))) return;
    mesh_cells[atomicAdd(draw_arguments[1], 1u)] = uint(index);
}

// Lists the cells of the mesh: first those that no cell of rays can hide, then those that one may.
layout(local_size_x = 512) in;
#include "render/surface.glsl"
#include "render/camera.glsl"
#include "render/cell_box.glsl"
#include "render/hybrid_cells.glsl"

layout(binding = 3, std430) buffer MeshCells { uint draw_arguments[16]; uint mesh_cells[]; };

void main() {
    int2 size = level_1_size >> (cell_level - 1);
    int index = int(gl_GlobalInvocationID.x);
    if (index >= size.x * size.y) return;
    int2 cell = int2(index % size.x, index / size.x);
    if (!has_patches(cell) || beyond_mesh(cell)) return;
    CellBox box = cell_box(cell, cell_level);
    if (cell_choice(cell, box) != cell_mesh) return;
    real2 span = ground_span(box);
    real2 reach = reach_over(sectors_of(box.low.xy, box.high.xy));
    if (span.x >= reach.y) return;
    if (span.y < reach.x)
        mesh_cells[atomicAdd(draw_arguments[1], 1u)] = uint(index);
    else
        mesh_cells[size.x * size.y + int(atomicAdd(draw_arguments[5], 1u))] = uint(index);
    // Rays then go behind the mesh instead of everywhere.
    draw_arguments[9] = 0u;
    draw_arguments[13] = 1u;
}

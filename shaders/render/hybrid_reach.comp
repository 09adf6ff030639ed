// Lowers the reach of the sectors of every cell that rays draw.
layout(local_size_x = 512) in;
#include "render/surface.glsl"
#include "render/camera.glsl"
#include "render/cell_box.glsl"
#include "render/hybrid_cells.glsl"

void main() {
    int2 size = level_1_size >> (cell_level - 1);
    int index = int(gl_GlobalInvocationID.x);
    if (index >= size.x * size.y) return;
    int2 cell = int2(index % size.x, index / size.x);
    if (!has_patches(cell) || beyond_mesh(cell)) return;
    CellBox box = cell_box(cell, cell_level);
    if (cell_choice(cell, box) != cell_rays) return;
    uint bits = floatBitsToUint(ground_span(box).x);
    int2 sectors = sectors_of(box.low.xy, box.high.xy);
    for (int i = 0; i < sectors.y; ++i) atomicMin(reach_m[(sectors.x + i) % sector_count], bits);
}

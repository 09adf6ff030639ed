// Chooses the cells around the eye that the mesh draws. First it finds the mesh's reach in every direction, up to the
// nearest cell of rays. Then it lists the mesh's cells in two halves: those that no cell of rays can hide, and those that
// one may. Where they are not worth their draws it lists nothing, and the mesh reaches nowhere. One group does it all,
// because a dispatch costs more than this work.
layout(local_size_x = 256) in;
#define MAKES_MESH_CELLS
#include "render/surface.glsl"
#include "render/camera.glsl"
#include "render/cell_box.glsl"
#include "render/hybrid_cells.glsl"
#include "render/hybrid_list.glsl"

uniform int2 first_cell;  // of the rectangle that the mesh may reach
uniform int2 cell_count;
uniform real least_gain;  // share of the picture; without so much the mesh is not worth its draws

shared int cells_of_mesh;  // before it is known what cells of rays leave of them
shared int gain;           // of the mesh, in 1/65536 of the picture

int2 cell_at(int index) { return first_cell + int2(index % cell_count.x, index / cell_count.x); }

void main() {
    int me = int(gl_LocalInvocationIndex);
    int count = cell_count.x * cell_count.y;
    int most = cell_capacity();
    for (int i = me; i < sector_count; i += 256) reach_m[i] = floatBitsToUint(mesh_end_m);
    if (me == 0) {
        gain = 0;
        cells_of_mesh = 0;
        uint vertices = 6u << (2 * cell_level);
        for (int i = 0; i < 8; ++i) draw_arguments[i] = (i & 3) == 0 ? vertices : 0u;
    }
    memoryBarrierBuffer();
    barrier();
    for (int i = me; i < count; i += 256) {
        int2 cell = cell_at(i);
        if (!has_patches(cell) || beyond_mesh(cell)) continue;
        CellBox box = cell_box(cell, cell_level);
        int choice = cell_choice(cell, box);
        if (choice == cell_mesh) atomicAdd(cells_of_mesh, 1);
        if (choice != cell_rays) continue;
        uint bits = floatBitsToUint(ground_span(box).x);
        int2 sectors = sectors_of(box.low.xy, box.high.xy);
        for (int k = 0; k < sectors.y; ++k) atomicMin(reach_m[(sectors.x + k) % sector_count], bits);
    }
    memoryBarrierBuffer();
    barrier();
    count = cells_of_mesh > 0 ? count : 0;
    for (int i = me; i < count; i += 256) {
        int2 cell = cell_at(i);
        if (!has_patches(cell) || beyond_mesh(cell)) continue;
        CellBox box = cell_box(cell, cell_level);
        if (cell_choice(cell, box) != cell_mesh) continue;
        real2 span = ground_span(box);
        real2 reach = reach_over(sectors_of(box.low.xy, box.high.xy));
        if (span.x >= reach.y) continue;
        atomicAdd(gain, int(65536.0 * gain_of_mesh(box) / (picture_size.x * picture_size.y)));
        uint number = uint(cell.y * (level_1_size.x >> (cell_level - 1)) + cell.x);
        if (span.y < reach.x)
            mesh_cells[atomicAdd(draw_arguments[1], 1u)] = number;
        else
            mesh_cells[most + int(atomicAdd(draw_arguments[5], 1u))] = number;
    }
    memoryBarrierBuffer();
    barrier();
    if (real(gain) > 65536.0 * least_gain) return;
    if (me == 0) {
        draw_arguments[1] = 0u;
        draw_arguments[5] = 0u;
    }
    for (int i = me; i < sector_count; i += 256) reach_m[i] = 0u;
}

// Cells by choice: arguments of draws, eight words each, the instances second; then the cells. The mesh has a buffer of its own,
// as shaders/render/mesh.vert reads it. The including side has cell_grid.glsl.
#include "render/ammann_choices.glsl"

layout(std430) buffer MeshCells { uint draw_arguments[8]; uint mesh_cells[]; };
layout(std430) buffer RayCells { uint ray_arguments[]; };

uniform int levels;

// Where the cells of a level of precision begin.
uint first_ray_cell(uint level) { return 8u * uint(levels) + level * uint(cell_count.x * cell_count.y); }

void set_count(uint choice, uint count) {
    if (choice == by_mesh)
        draw_arguments[1] = count;
    else
        ray_arguments[8u * (choice - by_rays) + 1u] = count;
}

void list_cell(uint choice, uint at, uint number) {
    if (choice == by_mesh)
        mesh_cells[at] = number;
    else
        ray_arguments[first_ray_cell(choice - by_rays) + at] = number;
}

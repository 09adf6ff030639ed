// The cells of the mesh that method "hybrid" draws.
// `draw_arguments`: four words of an indirect draw: of cells that no ray can hide, and of those that one may. `mesh_cells`: the
// first half, and the second. One shader makes the list, the others read it.
#ifdef MAKES_MESH_CELLS
layout(std430) coherent buffer MeshCells { uint draw_arguments[8]; uint mesh_cells[]; };
#else
layout(std430) readonly buffer MeshCells { uint draw_arguments[8]; uint mesh_cells[]; };
#endif

int cell_capacity() { return mesh_cells.length() / 2; }
bool mesh_is_drawn() { return draw_arguments[1] + draw_arguments[5] > 0u; }

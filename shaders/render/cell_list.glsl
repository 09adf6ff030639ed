// Cells whose bounds must be found again (render/methods/cell_bounds.h).
layout(std430) buffer CellList { uint listed; uint listed_cells[]; };
layout(std430) buffer CellMarks { uint cell_marks[]; };  // 1: listed

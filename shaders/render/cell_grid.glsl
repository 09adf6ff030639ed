// Square cells over the terrain; the last of a row and of a column end with it. Neighbours share a row of samples
// (render/methods/cell_bounds.h).
#include "maths/glsl_types.glsl"

uniform int cell_patches;  // in a row and a column
uniform int2 cell_count;   // in a row and a column

int2 cell_at(int number) { return int2(number % cell_count.x, number / cell_count.x); }

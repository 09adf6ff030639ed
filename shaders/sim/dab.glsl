// A dab's numbers and the first tile of those that it reaches (sim/passes/brush.h, set_dab). The including shader gives real
// painted_mask(int2): the mask as it was painted.
#include "maths/brush_modes.glsl"

uniform int2 first_tile;
layout(std140) uniform DabNumbers {
#include "maths/dab_numbers.glsl"
};

real load_mask(int2 at) { return dab_masked != 0 ? painted_mask(at) : real(1); }

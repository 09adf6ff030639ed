// Where a dab is and how strongly it acts, as uniforms (sim/passes/brush.h, set_dab). The including shader gives real
// painted_mask(int2): the mask as it was painted.
#include "maths/brush_modes.glsl"

uniform int2 first_tile;
uniform real2 cell_m;
uniform int2 dab_sample;
uniform real2 dab_offset;
uniform real dab_radius_m;
uniform real dab_falloff;
uniform int dab_curve;
uniform real2 dab_length_m;
uniform int dab_masked;

real load_mask(int2 at) { return dab_masked != 0 ? painted_mask(at) : real(1); }

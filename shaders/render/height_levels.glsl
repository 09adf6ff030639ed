// Heights at ever wider spacing: level l has a sample at every 2^l-th column and row of the terrain's, and its last ones lie on
// the terrain's far edges. All levels from 1 on lie in one image, where the host says (render/methods/height_levels.h).
#include "maths/glsl_types.glsl"

uniform int2 patches;

// The last column and row of a level.
int2 last_of(int level) { return (patches + (1 << level) - 1) >> level; }

// The column and row of the terrain that a sample of a level lies on.
int2 place_of(int2 at, int level) { return min(max(at, int2(0)) << level, patches); }

// Where the mesh reaches otherwise than before, pixels anywhere may change between mesh and rays: everything is drawn.
layout(local_size_x = 64) in;
#include "maths/glsl_types.glsl"
#include "render/redraw_marks.glsl"
#include "render/hybrid_sectors.glsl"

layout(std430) readonly buffer ReachBefore { uint reach_before_m[]; };

void main() {
    int sector = int(gl_GlobalInvocationID.x);
    if (sector < sector_count && reach_m[sector] != reach_before_m[sector]) redraw_all = 1u;
}

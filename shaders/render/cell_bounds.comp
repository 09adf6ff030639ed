// The lowest and the highest sample of the listed cells, with those of their far sides, and takes their marks away.
layout(local_size_x = 64) in;
#include "render/cell_grid.glsl"
#include "render/cell_list.glsl"

uniform sampler2D ground;
layout(rg32f) uniform writeonly image2D cell_bounds;

uniform int2 patches;

shared real2 found[64];

void main() {
    int me = int(gl_LocalInvocationIndex);
    for (uint i = gl_WorkGroupID.x; i < listed; i += gl_NumWorkGroups.x) {
        int2 cell = cell_at(int(listed_cells[i]));
        int2 first = cell * cell_patches;
        int2 last = min(first + cell_patches, patches);
        real2 bounds = real2(uintBitsToFloat(0x7f800000u), uintBitsToFloat(0xff800000u));
        for (int y = first.y; y <= last.y; ++y)
            for (int x = first.x + me; x <= last.x; x += 64) {
                real height = texelFetch(ground, int2(x, y), 0).r;
                bounds = real2(min(bounds.x, height), max(bounds.y, height));
            }
        found[me] = bounds;
        barrier();
        for (int half_way = 32; half_way > 0; half_way /= 2) {
            if (me < half_way) found[me] = real2(min(found[me].x, found[me + half_way].x), max(found[me].y, found[me + half_way].y));
            barrier();
        }
        if (me == 0) {
            imageStore(cell_bounds, cell, vec4(found[0], 0.0, 0.0));
            cell_marks[listed_cells[i]] = 0u;
        }
        barrier();
    }
}

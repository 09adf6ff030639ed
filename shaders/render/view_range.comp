// Counts the samples of a terrain by what its view shows there, so that the scale can end by it (render/view_range.h). VIEW_FILE
// names the view's file.
layout(local_size_x = 16, local_size_y = 16) in;
const bool count_steps = false;
#include "render/camera.glsl"
#include "render/whole_ground.glsl"
#include "maths/colour_map.glsl"

uniform sampler2D solid;
uniform sampler2D start;
uniform sampler2D grain;
uniform real3 sun;

#include "render/relief.glsl"
#include "render/view_point.glsl"
#include VIEW_FILE
#include "render/view_range_bins.glsl"

// How many samples are in each bin, and the largest value of all, as the bits of a float.
layout(std430) buffer Range { uint counts[]; };

shared uint group_counts[range_bins];
shared uint group_largest;

void main() {
    int me = int(gl_LocalInvocationIndex);
    for (int k = me; k < range_bins; k += 256) group_counts[k] = 0u;
    if (me == 0) group_largest = 0u;
    barrier();
    for (int k = 0; k < range_side * range_side; ++k) {
        ivec2 at = ivec2(gl_WorkGroupID.xy) * 16 * range_side + ivec2(gl_LocalInvocationID.xy) + 16 * ivec2(k % range_side, k / range_side);
        if (any(greaterThan(at, patches))) continue;
        float value = view_value(vec2(at));
        if (!(value > 0.0)) continue;
        // Bits of floats above 0 are in the order of the floats.
        uint bits = floatBitsToUint(value);
        atomicAdd(group_counts[bits >> range_shift], 1u);
        atomicMax(group_largest, bits);
    }
    barrier();
    for (int k = me; k < range_bins; k += 256)
        if (group_counts[k] > 0u) atomicAdd(counts[k], group_counts[k]);
    if (me == 0 && group_largest > 0u) atomicMax(counts[range_bins], group_largest);
}

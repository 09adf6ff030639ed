// Lists the cells of each choice, a group a choice, roughly from near to far: by rows, and in them by columns, from the eye's on.
// The order does not depend on the device, and so no bit of the picture does.
layout(local_size_x = 256) in;
#include "render/surface.glsl"
#include "render/cell_grid.glsl"
#include "render/ammann_lists.glsl"

layout(std430) readonly buffer Choices { uint choices[]; };

shared uint counts[256];

// The i-th of `count` columns or rows, those beside the middle first.
int outward(int i, int middle, int count) {
    int both_sides = 2 * min(middle, count - 1 - middle);
    if (i <= both_sides) return middle + ((i & 1) == 1 ? (i + 1) / 2 : -(i / 2));
    return 2 * middle < count ? i : count - 1 - i;
}

int cell_in_turn(int i, int2 middle) {
    return outward(i / cell_count.x, middle.y, cell_count.y) * cell_count.x + outward(i % cell_count.x, middle.x, cell_count.x);
}

void main() {
    int me = int(gl_LocalInvocationIndex);
    uint choice = gl_WorkGroupID.x;
    int all = cell_count.x * cell_count.y;
    int2 middle = min(max(origin_cell, int2(0)) / cell_patches, cell_count - 1);
    int run = (all + 255) / 256;
    int begin = min(me * run, all);
    int end = min(begin + run, all);
    uint mine = 0u;
    for (int i = begin; i < end; ++i) mine += choices[cell_in_turn(i, middle)] == choice ? 1u : 0u;
    counts[me] = mine;
    barrier();
    uint at = 0u;
    for (int i = 0; i < me; ++i) at += counts[i];
    if (me == 255) set_count(choice, at + mine);
    for (int i = begin; i < end; ++i) {
        int number = cell_in_turn(i, middle);
        if (choices[number] == choice) list_cell(choice, at++, uint(number));
    }
}

// The pyramid of highest samples over the listed slots, one group a slot.
layout(local_size_x = 256) in;
#include "render/slot_layout.glsl"

uniform int slots_in_row;
uniform sampler2D tile_heights;
layout(std430) readonly buffer SlotList { uint listed_slots[]; };
layout(r32f) coherent uniform image2D tile_tops;

void main() {
    int number = int(listed_slots[gl_WorkGroupID.x]);
    int2 slot = int2(number % slots_in_row, number / slots_in_row);
    int me = int(gl_LocalInvocationIndex);
    int2 size = room_patches / 2;
    int2 corner = slot_heights_corner(slot);
    for (int i = me; i < size.x * size.y; i += 256) {
        int2 cell = int2(i % size.x, i / size.x);
        real top = uintBitsToFloat(0xff800000u);
        for (int k = 0; k < 9; ++k) top = max(top, texelFetch(tile_heights, corner + 2 * cell + int2(k % 3, k / 3), 0).r);
        imageStore(tile_tops, slot_tops_texel(slot, cell, 1), vec4(top));
    }
    for (int level = 2; level <= slot_top_level; ++level) {
        memoryBarrierImage();
        barrier();
        size = slot_level_size(level);
        int2 last = slot_level_size(level - 1) - 1;
        for (int i = me; i < size.x * size.y; i += 256) {
            int2 cell = int2(i % size.x, i / size.x);
            real top = uintBitsToFloat(0xff800000u);
            for (int k = 0; k < 4; ++k) top = max(top, imageLoad(tile_tops, slot_tops_texel(slot, min(2 * cell + int2(k & 1, k >> 1), last), level - 1)).r);
            imageStore(tile_tops, slot_tops_texel(slot, cell, level), vec4(top));
        }
    }
}

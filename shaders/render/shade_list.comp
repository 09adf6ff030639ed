// Lists the blocks of the picture where anything was hit, and those where nothing was: the sky costs little to colour. One
// group looks at a square of blocks and lists it at once where its blocks are all the same.
layout(local_size_x = 16, local_size_y = 16) in;
#include "maths/glsl_types.glsl"
#include "render/block_pixels.glsl"

uniform sampler2D hits;
// Two draws, of blocks with nothing and with something in them, then the blocks of each.
layout(std430) buffer ShadeBlocks { uint block_words[]; };

uniform int2 blocks;
uniform int2 size;  // of the picture
uniform int skips_walls;  // 1: hits with a detail below 0 count as nothing

const int head_words = 2 * draw_words;

shared uint seen[large_block * large_block];

void list(uint kind, uint block) {
    uint place = atomicAdd(block_words[draw_words * int(kind)], 1u);
    block_words[head_words + int(kind) * blocks.x * blocks.y + int(place)] = block;
}

void main() {
    int me = int(gl_LocalInvocationIndex);
    const int count = large_block * large_block;
    if (me < count) seen[me] = 0u;
    barrier();
    // Each thread looks at 8 x 8 pixels, which lie in one block.
    const int side = large_block * block_pixels / 16;
    int2 first = (int2(gl_WorkGroupID.xy) * 16 + int2(gl_LocalInvocationID.xy)) * side;
    bool any_hit = false;
    for (int k = 0; k < side * side; ++k) {
        int2 at = min(first + int2(k % side, k / side), size - 1);
        vec2 hit = texelFetch(hits, at, 0).rg;
        any_hit = any_hit || !(isinf(hit.r) || (skips_walls == 1 && hit.g < 0.0));
    }
    int2 block = int2(gl_LocalInvocationID.xy) * side / block_pixels;
    if (any_hit) atomicOr(seen[block.y * large_block + block.x], 1u);
    barrier();
    if (me > 0) return;
    uint hit_blocks = 0u;
    for (int k = 0; k < count; ++k) hit_blocks += seen[k];
    int2 large = int2(gl_WorkGroupID.xy);
    // A square with few blocks of sky is shaded at once: software shades it cheaper than its blocks.
    if (hit_blocks == 0u || hit_blocks + uint(large_block) > uint(count)) {
        int columns = (blocks.x + large_block - 1) / large_block;
        list(hit_blocks == 0u ? 0u : 1u, large_bit | uint(large.y * columns + large.x));
        return;
    }
    for (int k = 0; k < count; ++k) {
        int2 at = large * large_block + int2(k % large_block, k / large_block);
        if (at.x < blocks.x && at.y < blocks.y) list(seen[k], uint(at.y * blocks.x + at.x));
    }
}

// Lists the blocks of the picture by what their beams found, so that rays are cast only where they are needed: nothing,
// flat ends alone, ground to walk to, or both. One group does it all, because a dispatch costs more than this work.
layout(local_size_x = 64) in;
#include "maths/glsl_types.glsl"
#include "render/beam_pixels.glsl"
#include "render/block_pixels.glsl"
#include "render/ray_kinds.glsl"
#ifdef BEHIND_MESH
#include "render/hybrid_list.glsl"
#else
bool mesh_is_drawn() { return false; }
#endif

uniform sampler2D beams;
// A draw of each kind without a mesh, then one of each behind a mesh, then the blocks of each kind.
layout(std430) buffer RayBlocks { uint block_words[]; };

uniform int2 blocks;
uniform int2 beam_count;

const int head_words = draw_words * 2 * ray_kinds;

shared uint counts[ray_kinds];

// Of the beams of a square: bit 0 where one walks, bit 1 where one ends in flat ground.
int look(int2 first, int side) {
    int seen = 0;
    for (int k = 0; k < side * side; ++k) {
        real found = texelFetch(beams, min(first + int2(k % side, k / side), beam_count - 1), 0).g;
        seen |= (found > 0.0 ? 1 : 0) | (found < 0.0 ? 2 : 0);
    }
    return seen;
}

void list(int seen, uint block) {
    int kind = seen == 0 ? kind_nothing : seen == 1 ? kind_walk : seen == 2 ? kind_flat : kind_walk_or_flat;
    uint place = atomicAdd(counts[kind], 1u);
    block_words[head_words + kind * blocks.x * blocks.y + int(place)] = block;
}

void main() {
    int me = int(gl_LocalInvocationIndex);
    if (me < ray_kinds) counts[me] = 0u;
    barrier();
    const int side = block_pixels / beam_pixels;
    int2 large = (blocks + large_block - 1) / large_block;
    for (int i = me; i < large.x * large.y; i += 64) {
        int2 first = int2(i % large.x, i / large.x) * large_block;
        int seen[large_block * large_block];
        int all = 0;
        for (int k = 0; k < large_block * large_block; ++k) {
            seen[k] = look((first + int2(k % large_block, k / large_block)) * side, side);
            all |= seen[k];
        }
        // Rays can do what their beams ask for and more; software shades a large square cheaper than its blocks.
        int others = 0;
        for (int k = 0; k < large_block * large_block; ++k) others += seen[k] == all ? 0 : 1;
        if (others < large_block) {
            list(all, large_bit | uint(i));
            continue;
        }
        for (int k = 0; k < large_block * large_block; ++k) {
            int2 block = first + int2(k % large_block, k / large_block);
            if (block.x < blocks.x && block.y < blocks.y) list(seen[k], uint(block.y * blocks.x + block.x));
        }
    }
    barrier();
    if (me > 0) return;
    bool mesh = mesh_is_drawn();
    for (int i = 0; i < 2 * ray_kinds; ++i) {
        block_words[draw_words * i] = mesh == (i >= ray_kinds) ? counts[i % ray_kinds] : 0u;
        block_words[draw_words * i + 1] = 1u;
        block_words[draw_words * i + 2] = 0u;
        block_words[draw_words * i + 3] = 0u;
    }
}

// Lists the blocks of the cells that the view may show, by how many triangles their mesh has: the simplified one, where it was
// made of the ground as it is, or the raised one. A thread for each block of a cell.
layout(local_size_x = 64) in;
#include "render/surface.glsl"
#include "render/uniform_block_at.glsl"

layout(std430) readonly buffer MeshCells { uint cell_arguments[8]; uint mesh_cells[]; };
layout(std430) readonly buffer EnvelopeVersions { float versions[]; };
layout(std430) readonly buffer SimplifiedVersions { float simplified_versions[]; };
layout(std430) readonly buffer SimplifiedBlocks { uint triangle_words[]; };
layout(std430) buffer UniformBlocks { uint draw_arguments[4 * block_kinds]; uint listed_blocks[]; };

uniform int cell_level;

void list_block(int2 block) {
    int tile = tile_of_block(block);
    int words = words_of_block(block);
    int kind = block_kinds - 1;
    if (simplified_versions[tile] == versions[tile] && triangle_words[words] != ~0u) {
        kind = 0;
        while (kind < block_kinds - 2 && triangle_words[words + kind_triangles[kind]] != 0u) ++kind;
    }
    uint vertices = uint(3 * kind_triangles[kind]);
    uint place = atomicAdd(draw_arguments[4 * kind], vertices) / vertices;
    listed_blocks[uint(kind * blocks.x * blocks.y) + place] = uint(block.y * blocks.x + block.x);
}

void main() {
    int index = int(gl_GlobalInvocationID.x);
    if (cell_level < envelope_level) {
        // The pyramid of a small or narrow terrain may have no cells as large as a block: there are few, and all are listed.
        if (index < blocks.x * blocks.y && cell_arguments[1] > 0u) list_block(int2(index % blocks.x, index / blocks.x));
        return;
    }
    int block_bits = cell_level - envelope_level;
    int place = index >> (2 * block_bits);
    if (place >= int(cell_arguments[1])) return;
    int cell = int(mesh_cells[place]);
    int columns = level_1_size.x >> (cell_level - 1);
    int within = index & ((1 << (2 * block_bits)) - 1);
    int2 block = (int2(cell % columns, cell / columns) << block_bits) + int2(within & ((1 << block_bits) - 1), within >> block_bits);
    if (block.x < blocks.x && block.y < blocks.y) list_block(block);
}

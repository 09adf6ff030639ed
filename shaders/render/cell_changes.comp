// Lists the cells that use samples of the listed tiles, each once. One group a tile.
layout(local_size_x = 64) in;
#include "render/cell_grid.glsl"
#include "render/cell_list.glsl"
#include "sim/tile_samples.glsl"

layout(std430) readonly buffer TileList { uint list_arguments[4]; uint listed_tiles[]; };

uniform int2 tiles;
uniform int2 patches;

void main() {
    int tile = int(listed_tiles[gl_WorkGroupID.y]);
    int2 first = int2(tile % tiles.x, tile / tiles.x) * tile_samples;
    int2 last = min(first + tile_samples - 1, patches);
    // A cell has the samples of its far sides too.
    int2 low = max(first - 1, int2(0)) / cell_patches;
    int2 high = min(last / cell_patches, cell_count - 1);
    int2 size = high - low + 1;
    for (int i = int(gl_LocalInvocationIndex); i < size.x * size.y; i += 64) {
        int2 cell = low + int2(i % size.x, i / size.x);
        int number = cell.y * cell_count.x + cell.x;
        if (atomicExchange(cell_marks[number], 1u) == 0u) listed_cells[atomicAdd(listed, 1u)] = uint(number);
    }
}

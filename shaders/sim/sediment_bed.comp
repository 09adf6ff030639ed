// After an exchange: the water's bed follows the ground on the listed tiles, a group for each strip of a tile.
layout(local_size_x = 64) in;
#include "sim/tile_samples.glsl"
#include "sim/water_images.glsl"

layout(r32f) uniform readonly image2D ground;
layout(r32f) uniform writeonly image2D bed;
layout(std430) readonly buffer TileList { uint list_arguments[4]; uint listed_tiles[]; };

void main() {
    int tile = int(listed_tiles[gl_WorkGroupID.y]);
    int2 first = int2(tile % tiles.x, tile / tiles.x) * tile_samples + int2(int(gl_LocalInvocationIndex), int(gl_WorkGroupID.x) * strip_rows);
    if (first.x >= samples.x) return;
    for (int row = 0; row < min(strip_rows, samples.y - first.y); ++row) {
        int2 at = first + int2(0, row);
        imageStore(bed, at + water_ghosts, imageLoad(ground, at));
    }
}

// Where a block's words begin in the lists of simplified meshes, and its tile.
#include "render/envelope.glsl"
#include "render/uniform_blocks.glsl"
#include "sim/tile_samples.glsl"

uniform int tile_columns;
uniform int2 blocks;  // in a row and a column

int tile_of_block(int2 block) {
    int2 at = block >> (tile_level - envelope_level);
    return at.y * tile_columns + at.x;
}

int words_of_block(int2 block) {
    const int across = tile_samples / envelope_patches;
    int2 within = block & (across - 1);
    return ((tile_of_block(block) * across + within.y) * across + within.x) * block_words;
}

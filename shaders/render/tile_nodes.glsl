// Where a tile's node is in the image of nodes (render/tiled/tile_nodes.h): levels one below the other, each with room for its
// rows below the one before. finest_rows: of tiles of the finest level.
int2 tile_node_texel(int2 tile, int level, int finest_rows) {
    return int2(tile.x, tile.y + 2 * finest_rows - ((2 * finest_rows) >> level) + level);
}

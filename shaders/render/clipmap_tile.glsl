// A tile of a ring. The including side has clipmap_rings.glsl and the patches of the terrain.

// In a row and a column.
int tile_patches() { return (side + 1) / 16; }

uint pack_tile(int2 tile, int level) { return uint(level) | uint(tile.x) << 4u | uint(tile.y) << 16u; }
int level_of(uint packed_tile) { return int(packed_tile & 15u); }
int2 place_of_tile(uint packed_tile) { return int2(packed_tile >> 4u & 4095u, packed_tile >> 16u); }

// From this column and row on the ground has no height any more: the terrain's sides. All levels have a sample there, so that they
// agree; from the terrain's edge to there, samples lie on the edge.
int2 sides_from() {
    int coarsest = levels - 1;
    return ((patches + (1 << coarsest) - 1) >> coarsest) << coarsest;
}

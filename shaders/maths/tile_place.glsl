// Where the eye is among the samples of a tile (maths/tile_cast.glsl).
struct TilePlace {
    int2 origin_cell;  // the patch of the tile's level under the eye, from the slot's first patch on
    real2 fraction;    // where in it
    real2 scale;       // samples of the tile's level for one of the finest
    int level;
};

// Samples of a tile in a row and a column: two to the power of the level. C++ compiles these lines too
// (sim/terrain/grid.h).
const int tile_level = 6;
const int tile_samples = 1 << tile_level;
// Groups that march down columns do a strip of a tile each; groups that need neighbours do a block.
const int tile_strips = 4;
const int strip_rows = tile_samples / tile_strips;
const int block_samples = 16;
const int tile_blocks = (tile_samples / block_samples) * (tile_samples / block_samples);

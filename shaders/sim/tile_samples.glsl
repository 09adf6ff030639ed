// Samples of a tile in a row and a column: two to the power of the level. C++ compiles these lines too
// (sim/terrain/grid.h).
const int tile_level = 6;
const int tile_samples = 1 << tile_level;

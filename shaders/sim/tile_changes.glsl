// What can change in a tile of the terrain. C++ compiles these lines too (sim/terrain/tiles.h).
const uint tile_ground = 0u;      // the ground, by anything but the water's own sub-steps
const uint tile_eroded = 1u;      // the ground, by those: the water's bed follows it at once
const uint tile_water = 2u;       // the water, by its sub-steps
const uint tile_placed = 3u;      // the water, by others
const uint tile_load = 4u;        // what the water carries
const uint tile_painted = 5u;     // hardness, mask, rain, roughness, infiltration
const uint tile_inundation = 6u;  // the map of the largest depth and arrival
const uint tile_any = 7u;         // the latest of all these, so that a reader looks at one number of most tiles
const uint tile_kinds = 8u;       // numbers that a tile has

// Which water is awake: bits of a word a tile, in the buffer WaterActivity. A tile's water is computed where it is active itself, or beside active water of a neighbour.
const uint wet = 1u;        // active in the last sub-step
const uint wet_north = 2u;  // active within reach of its northern neighbour, and so on
const uint wet_south = 4u;
const uint wet_west = 8u;
const uint wet_east = 16u;
const uint wet_all = 31u;
// Two stages of two samples each.
const int water_reach = 4;

// What a mask is made of, and how it meets what is painted. C++ compiles these lines too (sim/passes/mask_settings.h).
const int mask_source_height = 0;  // m
const int mask_source_slope = 1;  // degrees
const int mask_source_curvature = 2;  // 1/km, crests positive
const int mask_source_depth = 3;  // of water, m
const int mask_source_largest_depth = 4;  // so far, m
const int mask_source_arrival = 5;  // of water, s
const int mask_source_flow = 6;  // m³
const int mask_source_wear = 7;  // m, by all together, as deposition
const int mask_source_deposition = 8;
const int mask_source_regolith = 9;  // m
const int mask_source_difference = 10;  // m, of the ground since the start
const int mask_source_itself = 11;
const int mask_source_everything = 12;
const int mask_source_rectangle = 13;  // m, the distance from it

const int mask_join_replace = 0;
const int mask_join_add = 1;
const int mask_join_intersect = 2;
const int mask_join_subtract = 3;

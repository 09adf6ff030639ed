// What is beyond an edge of the map. C++ compiles these lines too (sim/passes/water_settings.h).
const int edge_wall = 0;
const int edge_open = 1;
const int edge_level = 2;
const int edge_inflow_kind = 3;
const int edge_wave = 4;
const int edge_periodic = 5;
const float no_sea = -1e30f;  // m, far below all ground: no sea stands beyond open edges

// Of layers of water. C++ compiles these lines too (sim/terrain/terrain.h).
const int water_ghosts = 2;       // samples around it, beyond the map's edges
const float wet_depth_m = 0.01f;  // where water is less deep, views of it show none, it has not arrived, and slopes are dry

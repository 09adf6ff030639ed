// Components of the painted layer. C++ compiles these lines too (sim/terrain/terrain_state.h).
const int layer_hardness = 0;
const int layer_mask = 1;
const int layer_rain = 2;

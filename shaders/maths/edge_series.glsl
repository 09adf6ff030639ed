// Steps of the tables that edges read in a tick. C++ compiles these lines too (sim/passes/water_settings.h).
const int edge_series_steps = 256;

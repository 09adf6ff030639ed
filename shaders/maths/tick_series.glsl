// Tables that the water reads in a tick, by equal steps of it. C++ compiles these lines too (sim/passes/tick_series.h).
const int tick_series_steps = 256;
const int tick_series_points = tick_series_steps + 1;  // that a table has room for
const int series_inflow = 0;  // mean of each step, m²/s into the map at inflow edges
const int series_rain = 1;    // mean of each step, m/s
const int series_wave = 2;    // at each point, m above the still level at wave edges
const int series_level = 3;   // at each point, m: held at level edges, still at wave edges, of the sea beyond open ones
const int tick_series_tables = 4;

// What WaterClock holds. C++ compiles these lines too, in a struct of the same name (sim/passes/water.cpp).
    float clock_left_s;       // of the tick
    float clock_dt_s;         // this sub-step; 0: the tick is done
    float clock_share_x;      // dt / dx, s/m
    float clock_share_y;
    float clock_drain;        // m/s
    float clock_friction;     // dt g n²
    float clock_at;           // share of the tick that is past, before this sub-step
    float clock_share;        // this sub-step's share of the tick
    float clock_fastest;      // m/s, over all tiles
    uint clock_edge_fastest;  // bits of the fastest wave beyond the edges in this tick's last sub-step, m/s
    float clock_rain;         // over this sub-step, m/s
    float clock_inflow;       // over this sub-step, m²/s into the map at inflow edges
    double book_rain_m;       // metres of rain on one sample, since the start
    double book_springs_m;    // metres from all springs
    double total_substeps;
    double total_listed;      // tiles, in all sub-steps together

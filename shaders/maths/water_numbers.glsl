// Of the water in a tick; C++ compiles these lines too (sim/passes/water_numbers.h).
NUMBER(int2, samples)            // columns, rows
NUMBER(int2, tiles)              // across, down
NUMBER(real2, cell_m)            // spacing of columns and of rows, m
NUMBER(real, tick_s)
NUMBER(real, water_gravity)      // m/s²
NUMBER(real, water_manning)      // Manning's n, s/m^(1/3)
NUMBER(real, water_roughness)    // gravity * Manning's n²
NUMBER(int, water_eulers)        // equal Euler steps that follow each other in a sub-step: 2 at order 1, 1 at order 2
NUMBER(int, rain_is_mapped)      // 1: rain differs from place to place, and is booked where it falls
NUMBER(int, rain_masked)         // 1: by the mask
NUMBER(real, evaporation_m_per_s)
NUMBER(real, infiltration_m_per_s)
NUMBER(real, loss_m_per_s)       // both together
NUMBER(int, every_tile)          // 1: all tiles have work
NUMBER(int, spring_count)
NUMBER(int, edge_kind_north)     // of maths/edge_kinds.glsl
NUMBER(int, edge_kind_south)
NUMBER(int, edge_kind_west)
NUMBER(int, edge_kind_east)
NUMBER(real, inflow_tick_mean)   // m²/s into the map over the tick
NUMBER(real, inflow_root_slope)  // root of the slope that spreads the inflow by conveyance
NUMBER(int, has_sea)             // 1: beyond open edges stands a sea of that level
NUMBER(int, level_moves)         // 1: within the tick

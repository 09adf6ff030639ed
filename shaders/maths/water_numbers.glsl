// Of the water in a tick; C++ compiles these lines too (sim/passes/water_numbers.h).
NUMBER(int2, samples)            // columns, rows
NUMBER(int2, tiles)              // across, down
NUMBER(real2, cell_m)            // spacing of columns and of rows, m
NUMBER(real, tick_s)
NUMBER(real, water_gravity)      // m/s²
NUMBER(real, water_roughness)    // gravity * Manning's n²
NUMBER(int, water_eulers)        // equal Euler steps that follow each other in a sub-step: 2 at order 1, 1 at order 2
NUMBER(real, rain_m_per_s)       // everywhere, or by the mask
NUMBER(real, even_rain_m_per_s)  // that falls everywhere; rain by the map is booked where it falls
NUMBER(int, rain_masked)         // 1: by the mask
NUMBER(real, loss_m_per_s)       // evaporation and infiltration together
NUMBER(int, every_tile)          // 1: all tiles have work
NUMBER(int, spring_count)
NUMBER(int, edge_kind_north)     // of maths/edge_kinds.glsl
NUMBER(int, edge_kind_south)
NUMBER(int, edge_kind_west)
NUMBER(int, edge_kind_east)
NUMBER(real, edge_level_m)       // held at level edges; still level at wave edges
NUMBER(real, edge_sea_m)         // level of the sea that stands beyond open edges; far below all ground: none does

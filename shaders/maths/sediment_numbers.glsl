// Of the exchange between bed and water; C++ compiles these lines too (sim/passes/sediment_step.h).
NUMBER(real2, sediment_strata)     // m: thickness of a pair of bedrock layers, 0: none; and hardness of the harder one
NUMBER(real, sediment_drag)        // Pa s²/m^(5/3): density of water * gravity * Manning's n²
NUMBER(real, sediment_critical)    // Pa: shear stress below which nothing is entrained
NUMBER(real, sediment_regolith)    // m/(s Pa): erodibility of regolith
NUMBER(real, sediment_bedrock)     // m/(s Pa): of bedrock
NUMBER(real, sediment_settling)    // m/s
NUMBER(real, sediment_speedup)     // how often an exchange counts for the bed (morphological factor)
NUMBER(real, sediment_bulking)     // metres of regolith that a metre of solid makes: 1 / (1 - porosity)
NUMBER(real, sediment_per_rock)    // 1 / speedup
NUMBER(real, sediment_per_loose)   // 1 / (speedup * bulking)
NUMBER(real, sediment_inflow)      // solid by volume in the water that comes in by edges of kind inflow
NUMBER(int, sediment_masked)       // 1: water takes as much as the mask says
NUMBER(int, sediment_below)        // 1: what settles raises no sample above its highest neighbour

// Of a sub-step of thermal erosion; C++ compiles these lines too (sim/passes/thermal_step.h).
NUMBER(real2, cell_m)          // spacing of columns and of rows, m
NUMBER(real2, face_share)      // rate * sub-step / spacing: square metres per second times seconds per metre
NUMBER(real, repose_slope)     // tangents of angles: of repose of regolith, dry
NUMBER(real, wet_slope)        // under water
NUMBER(real, bedrock_slope)    // that bedrock fails at
NUMBER(real, thermal_bulking)  // metres of regolith that a metre of solid makes: 1 / (1 - porosity)
NUMBER(real, weathering_m)     // of bare bedrock that weather in a sub-step

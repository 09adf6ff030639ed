// Of a dab; C++ compiles these lines too (sim/passes/dab_numbers.h).
NUMBER(real2, cell_m)         // spacing of columns and of rows, m
NUMBER(int2, dab_sample)      // the sample at or before the dab's centre (column, row)
NUMBER(real2, dab_offset)     // the centre's offset from that sample in spacings, 0 to 1
NUMBER(real2, dab_length_m)   // from the centre to the other end (column, row): a dab along a line; 0: a round one
NUMBER(real, dab_radius_m)
NUMBER(real, dab_falloff)     // 0 (hard edge) to 1 (soft all the way): the share of the radius over which it fades
NUMBER(int, dab_curve)        // how it fades: of maths/brush_modes.glsl
NUMBER(int, dab_masked)       // 1: as far as the painted mask says
NUMBER(real, dab_amount_m)    // raise, lower: at full weight; noise, stamp: the height of 1
NUMBER(real, dab_blend)       // smooth, flatten, ramp, terrace, stamp, paint: share of the way at full weight
NUMBER(real2, dab_target_m)   // two words: height to reach; of a ramp's beginning, of a step, that a stamp's 0 stands on;
                              // paint: the value, in the first
NUMBER(int, dab_on_regolith)  // 1: raise adds regolith rather than bedrock
NUMBER(int, dab_takes)        // 1: takes water
NUMBER(real, ramp_rise_m)     // how much higher a ramp's end is
NUMBER(int, noise_kind)       // of maths/brush_modes.glsl
NUMBER(int, noise_octaves)
NUMBER(real, noise_gain)      // an octave against the one before it
NUMBER(real, noise_warp)      // how far the plane is bent first, in wavelengths
NUMBER(uint, noise_seed)
NUMBER(real, noise_wavelength_m)
NUMBER(real, terrace_step_m)  // height of a step
NUMBER(real, terrace_flat)    // 0 to 1: share of a step that is level
NUMBER(int2, stamp_samples)   // columns and rows of the stamp
NUMBER(real2, stamp_columns)  // of them, a metre along the terrain's columns
NUMBER(real2, stamp_rows)     // and along its rows
NUMBER(real, stamp_zero)      // which of its heights, 0 to 1, stands on the ground
NUMBER(int, stamp_mode)       // of maths/brush_modes.glsl
NUMBER(int, path_points)      // of the line, at least 2
NUMBER(real, path_half_width_m)
NUMBER(real, path_cut_slope)  // of its sides where the ground is higher: rise over run
NUMBER(real, path_fill_slope) // and where it is lower
NUMBER(int, path_cuts)        // 1: it takes what is higher
NUMBER(int, path_fills)       // 1: it fills what is lower

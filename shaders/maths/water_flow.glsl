// The water that leaves a sample over its faces. Needs maths/water.glsl, and
//   cell_m        real2, spacing, m
//   water_eulers  int, Euler steps that follow each other in a sub-step

// In an Euler step, m. Sums go in pairs of opposite faces.
real water_outflow(WaterFace west, WaterFace east, WaterFace south, WaterFace north) {
    precise real x = max(east.mass, real(0)) + max(-west.mass, real(0));
    precise real y = max(north.mass, real(0)) + max(-south.mass, real(0));
    precise real outflow = water_share.x * x + water_share.y * y;
    return outflow;
}

// The flow so far, m³ in two words, after a stage: SSP-RK2 is the mean of two Euler steps.
real2 flow_counted(real2 flow, real outflow) {
    precise real volume = (cell_m.x * cell_m.y) * outflow;
    precise real mean = real(0.5) * volume;
    return add_increment(flow, water_eulers == 1 ? mean : volume);
}

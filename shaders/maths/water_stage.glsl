// A sample after one of the two stages of a sub-step. Order 1: each stage is an Euler step. Order 2: the stages of SSP-RK2,
// where `start` is the sample before the sub-step. Needs maths/water.glsl.

real4 water_after_stage(int stage, real4 start, real4 here, WaterChange change) {
    if (water_order == 1) return water_euler(here, change);
    return stage == 1 ? water_first_stage(here, change) : water_second_stage(start, here, change);
}

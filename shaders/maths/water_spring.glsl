// What a spring gives to its sample at the start of a sub-step. Needs maths/two_sum.glsl and water_eulers
// (maths/water_numbers.glsl).

// Metres, from a rate in m/s over the sub-step of Euler steps of dt seconds.
real spring_gain(real rate, real dt) {
    precise real gain = rate * (dt * real(water_eulers));
    return gain;
}

real4 water_with_spring(real4 water, real gain) {
    real2 depth = add_increment(real2(water.x, water.y), gain);
    return real4(depth.x, depth.y, water.z, water.w);
}

// One dab of water on one sample. Needs maths/brush_weight.glsl, maths/two_sum.glsl and the numbers of
// maths/dab_numbers.glsl.

// Metres of depth that the dab adds; no more is taken than there is.
real water_brush_change(int2 at, real4 water) {
    precise real amount = brush_weight_at(at) * dab_amount_m;
    if (dab_takes == 1) return -min(amount, water.x);
    return amount;
}

// Water that is taken takes its share of the discharge with it; what is added stands still.
real4 water_brush_sample(real4 water, real change) {
    real2 depth = add_increment(real2(water.x, water.y), change);
    precise real share = depth.x / water.x;
    if (change >= real(0)) share = real(1);
    precise real east = water.z * share;
    precise real north = water.w * share;
    return real4(depth.x, depth.y, east, north);
}

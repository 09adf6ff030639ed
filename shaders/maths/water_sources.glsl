// Rain, evaporation and infiltration at one sample. Needs maths/two_sum.glsl and the numbers of
// maths/water_numbers.glsl.

// Metres that leave a sample in dt seconds where so much evaporates and infiltrates, m/s: no more than it has.
real water_loss(real4 water, real rate, real dt) {
    precise real wanted = rate * dt;
    return min(wanted, water.x);
}

// Rain at a sample, m/s: what falls everywhere, or where the mask is, and what was painted there, mm/h.
real water_rain(real rain_m_per_s, real mask, real painted_mm_per_h) {
    real everywhere = rain_masked == 1 ? mask : real(1);
    precise real rain = rain_m_per_s * everywhere + painted_mm_per_h * real(2.7777777777777776e-7);
    return rain;
}

// Metres of rain are added; metres of loss take their share of the discharge with them. Rain below one ulp of the depth
// adds up in the low word.
real4 water_with_sources(real4 water, real rain, real loss) {
    real2 depth = add_increment(real2(water.x, water.y), -loss);
    precise real share = depth.x / water.x;
    if (!(loss > real(0))) share = real(1);
    precise real east = water.z * share;
    precise real north = water.w * share;
    depth = add_increment(depth, rain);
    return real4(depth.x, depth.y, east, north);
}

// Rain, evaporation and infiltration at one sample. Needs maths/two_sum.glsl, and
//   rain_m_per_s   real
//   loss_m_per_s   real, evaporation and infiltration together

// Metres that leave a sample in dt seconds: no more than it has.
real water_loss(real4 water, real dt) {
    precise real wanted = loss_m_per_s * dt;
    return min(wanted, water.x);
}

// Rain adds; what a sample loses takes its share of the discharge with it. Rain below one ulp of the depth adds up in
// the low word.
real4 water_with_sources(real4 water, real dt, real loss) {
    precise real rain = rain_m_per_s * dt;
    real2 depth = add_increment(real2(water.x, water.y), -loss);
    precise real share = depth.x / water.x;
    if (!(loss > real(0))) share = real(1);
    precise real east = water.z * share;
    precise real north = water.w * share;
    depth = add_increment(depth, rain);
    return real4(depth.x, depth.y, east, north);
}

// What covers the land at a sample, real4(Manning's n times its share, that share, infiltration times its share, that share): s/m^(1/3)
// and mm/h. A share, 0 to 1, says how far the number holds in place of the parameter (docs/numerics.md, "Land cover"). Where it is 0
// the parameter's own bits are used, so that what was painted and undone leaves no trace. Needs the numbers of
// maths/water_numbers.glsl.

// A number of the land cover and the parameter's value, by its share.
real land_cover_mixed(real2 number, real parameter) {
    precise real mixed = number.x + (real(1) - number.y) * parameter;
    return mixed;
}

// Manning's n, s/m^(1/3).
real land_cover_manning(real4 cover) {
    return cover.y == real(0) ? water_manning : land_cover_mixed(real2(cover.x, cover.y), water_manning);
}

// Gravity times Manning's n².
real land_cover_roughness(real4 cover) {
    real manning = land_cover_manning(cover);
    precise real roughness = (water_gravity * manning) * manning;
    return cover.y == real(0) ? water_roughness : roughness;
}

// What evaporates and infiltrates together, m/s.
real land_cover_loss(real4 cover) {
    precise real infiltration = cover.z * real(2.7777777777777776e-7);
    precise real loss = evaporation_m_per_s + land_cover_mixed(real2(infiltration, cover.w), infiltration_m_per_s);
    return cover.w == real(0) ? loss_m_per_s : loss;
}

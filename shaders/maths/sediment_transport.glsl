// Sediment that rides on the water's limited fluxes (docs/numerics.md, "Sediment"). A load is metres of solid in the water
// above a sample, two words. Needs maths/water.glsl.

// Volume of solid in the water's volume.
real sediment_concentration(real depth, real load) {
    precise real share = load / max(depth, real(1e-30));
    return depth > real(0) ? share : real(0);
}

// Solid that passes a face with its water, m²/s: upwind, so that no concentration leaves the bounds of its neighbours.
real sediment_flux(real mass, real before, real behind) {
    precise real flux = mass * (mass > real(0) ? before : behind);
    return flux;
}

real sediment_gain(real west, real east, real south, real north) {
    precise real gain = water_share.x * (west - east) + water_share.y * (south - north);
    return gain;
}

// The stages of SSP-RK2, as the water's: the first one's low word is its gain.
real2 sediment_first_stage(real2 load, real gain) { return real2(add_increment(load, gain).x, gain); }

real2 sediment_second_stage(real2 start, real2 first, real gain) {
    precise real both = real(0.5) * (first.y + gain);
    return add_increment(start, both);
}

// After one of the stages, as the water (maths/water_stage.glsl).
real2 sediment_after_stage(int stage, real2 start, real2 load, real gain) {
    if (water_order == 1) return add_increment(load, gain);
    return stage == 1 ? sediment_first_stage(load, gain) : sediment_second_stage(start, load, gain);
}

// Suspended sediment and the bed exchange solid (docs/numerics.md, "Sediment"). A load is metres of solid in the water
// above a sample, two words. Needs maths/water.glsl and
//   sediment_dt        real, s: the span of an exchange
//   the numbers of maths/sediment_numbers.glsl

// Largest change of the bed in a sub-step, as a share of the water's depth; largest concentration, by volume; and the
// load below which all of it settles at once, m.
const real sediment_most_change = real(0.1);
const real sediment_densest = real(0.3);
const real sediment_least = real(1e-9);

// Density of water * gravity * Manning's n² where gravity * n² is so much, Pa s²/m^(5/3).
real sediment_drag_of(real roughness) {
    precise real drag = real(1000) * roughness;
    return drag;
}

// Shear stress of the water on its bed by Manning's law, Pa, by that drag.
real sediment_shear(real4 water, real drag) {
    real2 velocity = water_velocity(water.x, real2(water.z, water.w));
    precise real square = velocity.x * velocity.x + velocity.y * velocity.y;
    precise real shear = (drag * square) * inverse_cube_root(max(water.x, water_film));
    return water.x > water_film ? shear : real(0);
}

// Hardness of a sample by what was painted, real4(hardness, mask, …): where the mask is 0 nothing is taken.
real sediment_hardness(real4 painted) {
    precise real softness = (real(1) - painted.x) * (sediment_masked == 1 ? painted.y : real(1));
    precise real hardness = real(1) - softness;
    return hardness;
}

// Hardness of bedrock at a height: layers in pairs, the lower one of each the harder.
real sediment_stratum(real height) {
    if (sediment_strata.x <= real(0)) return real(0);
    precise real pairs = height / sediment_strata.x;
    precise real part = pairs - floor(pairs);
    return part < real(0.5) ? sediment_strata.y : real(0);
}

struct SedimentSample {
    real4 solid;
    real2 load;
};

// The sample after an exchange. Painted hardness, 0 to 1, holds for regolith and bedrock; layers for bedrock. `is_base`:
// on the map's edge bedrock stays, for beyond it lies the base level that all erosion works towards. `drop`: how far the
// lowest neighbour's ground lies below this one's, m; a sub-step erodes half of that at most, so that water digs no pits. `rise`:
// how far the highest one's lies above, m; where that is asked for, a sub-step raises the ground by half of it at most.
SedimentSample sediment_exchange(real4 water, real shear, SedimentSample before, real hardness, bool is_base, real drop, real rise) {
    real depth = water.x;
    real load = before.load.x;
    // d load / dt = entrainment - settling load / depth over the span, its exponential by 1 / (1 + x + x²/2), which is above
    // 0 for any span: after it, load = kept load + grown entrainment span.
    precise real x = (sediment_dt * sediment_settling) / max(depth, water_film);
    precise real kept = real(1) / (real(1) + x + real(0.5) * (x * x));
    precise real grown = (real(1) + real(0.5) * x) * kept;
    precise real excess = max(shear - sediment_critical, real(0)) * (sediment_dt * (real(1) - hardness));
    real softness = is_base ? real(0) : real(1) - sediment_stratum(before.solid.x);
    precise real lost = load * (kept - real(1));
    precise real wanted = lost + grown * (sediment_regolith * excess);
    precise real wanted_rock = lost + grown * (sediment_bedrock * (excess * softness));
    // How much the load may grow: the bed's share of the depth, and no denser than water can be.
    precise real step = sediment_most_change * depth;
    precise real most_rock = step * sediment_per_rock;
    precise real lower = (max(drop, real(0)) * real(0.5)) * sediment_per_loose;
    precise real dense = sediment_densest * depth - load;
    real most = min(min(most_rock, lower), max(dense, real(0)));

    // Regolith first, a touch less than there is, for its second word may be below 0; bedrock in the part of the span that
    // is left when there is none any more.
    precise real there = (max(before.solid.z, real(0)) * real(0.9999998)) * sediment_per_loose;
    real loose = min(max(min(wanted, most), real(0)), there);
    precise real rest = wanted > loose ? real(1) - loose / wanted : real(0);
    precise real rock_left = max(wanted_rock, real(0)) * rest;
    precise real room = most - loose;
    real rock = wanted > real(0) ? min(rock_left, max(room, real(0))) : real(0);

    // What settles; all of it from water that no longer flows, or that carries next to nothing.
    real settled = max(-wanted, real(0));
    precise real left = load - settled;
    precise real slowest = step * sediment_per_loose;
    bool all = depth <= water_film || (wanted <= real(0) && left < sediment_least);
    settled = all ? load : min(settled, slowest);
    precise real highest = (max(rise, real(0)) * real(0.5)) * sediment_per_loose;
    bool lifts = sediment_below == 1 && settled > highest;
    settled = lifts ? highest : settled;
    all = all && !lifts;

    precise real metres_settled = ((settled + (all ? before.load.y : real(0))) * sediment_speedup) * sediment_bulking;
    precise real metres_loose = min((loose * sediment_speedup) * sediment_bulking, before.solid.z);
    precise real metres_rock = rock * sediment_speedup;
    SedimentSample after;
    real2 bedrock = add_increment(real2(before.solid.x, before.solid.y), -metres_rock);
    real2 regolith = add_increment(real2(before.solid.z, before.solid.w), metres_settled > real(0) ? metres_settled : -metres_loose);
    precise real gain = loose + rock;
    real2 carried = add_increment(before.load, settled > real(0) ? -settled : gain);
    after.solid = real4(bedrock.x, bedrock.y, regolith.x, regolith.y);
    after.load = all ? real2(real(0), real(0)) : carried;
    return after;
}

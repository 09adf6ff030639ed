// Shallow water: MUSCL, the hydrostatic reconstruction of Chen & Noelle (2017) and HLL, along one axis at a time
// (docs/numerics.md, "Water"). Everything turns and mirrors to the bit. The including side gives
// inverse_cube_root_seed() and
//   water_order    const int, 1 or 2
//   the numbers of maths/water_numbers.glsl
//   water_share    real2, sub-step / spacing, s/m
//   water_drain    real, m/s: 1 / (2 sub-step (1/dx + 1/dy)), a touch less: no face takes more of its side's depth
//   water_friction real, sub-step * gravity * Manning's n²; 0: none
// A sample's water is real4(depth high, depth low, discharge east, discharge north): m, m, m²/s, m²/s.
#include "maths/cube_root.glsl"
#include "maths/two_sum.glsl"

// Thinner water does not flow, m; also the depth below which velocity fades (Kurganov & Petrova 2007).
const real water_film = real(1e-6);
// Neighbours whose levels differ by less than this, m, plus this share of their depth, rest; and discharges, m²/s.
const real water_rest_level = real(1e-6);
const real water_rest_share = real(2.384185791015625e-7);
const real water_rest_discharge = real(1e-6);

// A sample as fluxes along one axis see it. Velocities in m/s: along the axis, and across it.
struct WaterCell {
    real depth;
    real bed;
    real along;
    real across;
    bool quiet;  // its discharge counts as none
};

// Change of depth, level and velocities over one spacing.
struct WaterSlope {
    real depth;
    real level;
    real along;
    real across;
};

// What passes a face per second and metre. `before` and `behind` are the momentum fluxes that the samples before
// and behind it feel, less the pressure of their own water at the face: a lake at rest has zeros.
struct WaterFace {
    real mass;
    real before;
    real behind;
    real across;
    real level_before;  // how far the level rises from the sample before it to the face, and from the face on, m
    real level_behind;
    bool rests;
};

// Rates of a sample, times the sub-step.
struct WaterChange {
    real depth;
    real east;
    real north;
    bool rests;
};

// u = 2 h q / (h² + max(h², film²)).
real2 water_velocity(real depth, real2 discharge) {
    precise real square = depth * depth;
    precise real divisor = square + max(square, water_film * water_film);
    precise real factor = (depth + depth) / divisor;
    precise real x = factor * discharge.x;
    precise real y = factor * discharge.y;
    return real2(x, y);
}

WaterCell water_cell(real4 water, real bed, real2 velocity) {
    WaterCell cell;
    cell.depth = water.x;
    cell.bed = bed;
    cell.along = velocity.x;
    cell.across = velocity.y;
    cell.quiet = max(abs(water.z), abs(water.w)) <= water_rest_discharge;
    return cell;
}

// The same sample seen along the other axis.
WaterCell water_turned(WaterCell cell) {
    WaterCell turned = cell;
    turned.along = cell.across;
    turned.across = cell.along;
    return turned;
}

// Level of b above a. Depths and beds are subtracted like from like: a bed at 1,000 m costs no digit of the level.
real water_rise(WaterCell a, WaterCell b) {
    precise real sum = (b.depth - a.depth) + (b.bed - a.bed);
    return sum;
}

// Nothing drives water from one to the other: their levels agree, or the higher one has none that flows.
bool water_still(WaterCell a, WaterCell b) {
    real rise = water_rise(a, b);
    precise real threshold = water_rest_level + water_rest_share * max(a.depth, b.depth);
    real above = rise > real(0) ? b.depth : a.depth;
    return abs(rise) <= threshold || above <= water_film;
}

// Whether the face between a and b contributes nothing: rest is part of the scheme, so that what sleeps and what is
// computed agree (law 2). All that the face's values hang on is looked at.
bool water_face_rests(WaterCell before, WaterCell a, WaterCell b, WaterCell behind) {
    bool rests = a.quiet && b.quiet && water_still(a, b);
    if (water_order == 2)
        rests = rests && before.quiet && behind.quiet && water_still(before, a) && water_still(b, behind);
    return rests;
}

// Generalised minmod: the smallest of theta a, (a + b) / 2, theta b where all have one sign, else 0.
real water_limited(real a, real b, real theta) {
    precise real first = theta * a;
    precise real second = theta * b;
    precise real middle = real(0.5) * (a + b);
    real rising = max(min(min(first, second), middle), real(0));
    real falling = min(max(max(first, second), middle), real(0));
    precise real slope = rising + falling;
    return slope;
}

// Theta is 1.8, but on the level 1 where the depth is less than the drop of the bed to a neighbour: with more there,
// thin water on rough slopes is held behind dams that are not there.
WaterSlope water_slope(WaterCell before, WaterCell cell, WaterCell behind) {
    WaterSlope slope;
    if (water_order == 1) {
        slope.depth = real(0);
        slope.level = real(0);
        slope.along = real(0);
        slope.across = real(0);
        return slope;
    }
    precise real drop_before = cell.bed - before.bed;
    precise real drop_behind = cell.bed - behind.bed;
    real theta = cell.depth < max(drop_before, drop_behind) ? real(1) : real(1.8);
    precise real depth_before = cell.depth - before.depth;
    precise real depth_behind = behind.depth - cell.depth;
    precise real along_before = cell.along - before.along;
    precise real along_behind = behind.along - cell.along;
    precise real across_before = cell.across - before.across;
    precise real across_behind = behind.across - cell.across;
    slope.depth = water_limited(depth_before, depth_behind, real(1.8));
    slope.level = water_limited(water_rise(before, cell), water_rise(cell, behind), theta);
    slope.along = water_limited(along_before, along_behind, real(1.8));
    slope.across = water_limited(across_before, across_behind, real(1.8));
    return slope;
}

// Rise of the bed from a sample to a face, or from a face to a sample; at most the rise to the sample beyond. The
// limiter treats depth and level separately. Where their slopes disagree, the bed at the face would form a dam or a pit
// that is not there.
real water_bed_rise(WaterSlope slope, real fall) {
    precise real rise = real(0.5) * (slope.level - slope.depth);
    return min(max(rise, min(fall, real(0))), max(fall, real(0)));
}

// And its level.
real water_level_rise(WaterSlope slope, real bed_rise) {
    precise real free = real(0.5) * (slope.level - slope.depth);
    precise real whole = real(0.5) * slope.level;
    precise real held = bed_rise + real(0.5) * slope.depth;
    return bed_rise == free ? whole : held;
}

// The face between a sample and the one behind it (east or north of it).
WaterFace water_face(WaterCell a, WaterSlope slope_a, WaterCell b, WaterSlope slope_b, bool rests) {
    precise real h_a = a.depth + real(0.5) * slope_a.depth;
    precise real h_b = b.depth - real(0.5) * slope_b.depth;
    precise real u_a = a.along + real(0.5) * slope_a.along;
    precise real u_b = b.along - real(0.5) * slope_b.along;
    precise real v_a = a.across + real(0.5) * slope_a.across;
    precise real v_b = b.across - real(0.5) * slope_b.across;

    // Depths above the reconstructed bed, min(max(beds), min(levels)): Chen & Noelle 2017, (2.17) to (2.21), written
    // with the step of the level so that beds are never summed.
    precise real fall = b.bed - a.bed;
    real level_a = water_level_rise(slope_a, water_bed_rise(slope_a, fall));
    real level_b = water_level_rise(slope_b, water_bed_rise(slope_b, fall));
    precise real step = water_rise(a, b) - (level_a + level_b);
    precise real over_b = h_b - step;
    precise real over_a = h_a + step;
    real room_a = max(min(h_a, over_b), max(real(0), -step));
    real room_b = max(min(h_b, over_a), max(real(0), step));
    real d_a = min(h_a, room_a);
    real d_b = min(h_b, room_b);

    // HLL with the speeds of Einfeldt, and of a front where one side is dry (Toro 2001, 10.5 and 6.3).
    precise real square_a = water_gravity * d_a;
    precise real square_b = water_gravity * d_b;
    precise real c_a = sqrt(square_a);
    precise real c_b = sqrt(square_b);
    precise real slow_a = u_a - c_a;
    precise real slow_b = u_b - c_b;
    precise real fast_a = u_a + c_a;
    precise real fast_b = u_b + c_b;
    precise real front_b = u_b - (c_b + c_b);
    precise real front_a = u_a + (c_a + c_a);
    real low = d_a > real(0) ? (d_b > real(0) ? min(slow_a, slow_b) : slow_a) : front_b;
    real high = d_b > real(0) ? (d_a > real(0) ? max(fast_a, fast_b) : fast_b) : front_a;
    low = min(low, real(0));
    high = max(high, real(0));
    precise real span = high - low;
    precise real inverse = real(1) / max(span, real(1e-30));

    precise real q_a = d_a * u_a;
    precise real q_b = d_b * u_b;
    precise real both = low * high;
    precise real mass = ((high * q_a - low * q_b) + both * (d_b - d_a)) * inverse;
    precise real carried = ((high * (q_a * u_a) - low * (q_b * u_b)) + both * (q_b - q_a)) * inverse;
    precise real thrust = ((real(0.5) * water_gravity) * ((d_b - d_a) * (d_b + d_a))) * inverse;
    precise real fall_a = (water_gravity * h_a) * max(room_a - h_a, real(0));
    precise real fall_b = (water_gravity * h_b) * max(room_b - h_b, real(0));

    // Draining: a face takes no more than its share of the water before it, and momentum with it (Bollermann et al.
    // 2011 limit the sub-step of each face to the same end).
    precise real most = h_a * water_drain;
    precise real least = -(h_b * water_drain);
    real limited = min(max(mass, least), most);
    precise real share = limited / mass;
    if (limited == mass) share = real(1);

    WaterFace face;
    precise real before = (carried * share - low * thrust) - fall_a;
    precise real behind = (carried * share - high * thrust) - fall_b;
    precise real across = limited * (limited > real(0) ? v_a : v_b);
    face.mass = rests ? real(0) : limited;
    face.before = rests ? real(0) : before;
    face.behind = rests ? real(0) : behind;
    face.across = rests ? real(0) : across;
    face.level_before = level_a;
    face.level_behind = level_b;
    face.rests = rests;
    return face;
}

// A sample's change by its four faces over the sub-step; sums go in pairs of opposite faces.
WaterChange water_change(real depth, WaterFace west, WaterFace east, WaterFace south, WaterFace north) {
    precise real weight = water_gravity * depth;
    precise real push_x = (east.before - west.behind) + weight * (east.level_before + west.level_behind);
    precise real push_y = (north.before - south.behind) + weight * (north.level_before + south.level_behind);
    precise real gain = water_share.x * (west.mass - east.mass) + water_share.y * (south.mass - north.mass);
    precise real gain_x = water_share.y * (south.across - north.across) - water_share.x * push_x;
    precise real gain_y = water_share.x * (west.across - east.across) - water_share.y * push_y;
    WaterChange change;
    change.rests = west.rests && east.rests && south.rests && north.rests;
    change.depth = gain;
    change.east = change.rests ? real(0) : gain_x;
    change.north = change.rests ? real(0) : gain_y;
    return change;
}

// Manning friction over the sub-step by its closed root, q = 2 q* / (1 + sqrt(1 + 4 k |q*|)) with
// k = dt g n² / h^(7/3): implicit, so thin water is slowed and never turned round.
real2 water_slowed(real depth, real2 discharge) {
    real h = max(depth, real(1e-9));
    precise real k = (water_friction * inverse_cube_root(h)) / (h * h);
    precise real square = discharge.x * discharge.x + discharge.y * discharge.y;
    precise real speed = sqrt(square);
    precise real under = real(1) + real(4) * (k * speed);
    precise real root = sqrt(under);
    precise real factor = real(2) / (real(1) + root);
    precise real x = factor * discharge.x;
    precise real y = factor * discharge.y;
    return real2(x, y);
}

// Discharge after a change and friction; 0 where the sample rests or is dry. Velocity is limited to half a spacing per
// sub-step; on squares that is twice what the sub-step was made for. A sub-step as long as slow water allows can be too long
// for water above a cliff, which would gain the whole fall at once. The next sub-steps are shorter.
real2 water_discharge(real depth, real2 discharge, WaterChange change) {
    precise real x = discharge.x + change.east;
    precise real y = discharge.y + change.north;
    real2 after = real2(x, y);
    if (water_friction > real(0)) after = water_slowed(depth, after);
    precise real most_x = (real(0.5) / water_share.x) * depth;
    precise real most_y = (real(0.5) / water_share.y) * depth;
    after.x = min(max(after.x, -most_x), most_x);
    after.y = min(max(after.y, -most_y), most_y);
    if (change.rests || depth <= real(0)) after = real2(real(0), real(0));
    return after;
}

// The first stage of SSP-RK2 (Shu & Osher 1988): a whole Euler step. Its low word is the change of depth.
real4 water_first_stage(real4 water, WaterChange change) {
    real2 depth = add_increment(real2(water.x, water.y), change.depth);
    real2 discharge = water_discharge(depth.x, real2(water.z, water.w), change);
    return real4(depth.x, change.depth, discharge.x, discharge.y);
}

// The second: half of the start, half of an Euler step from the first.
real4 water_second_stage(real4 start, real4 first, WaterChange change) {
    precise real gain = real(0.5) * (first.y + change.depth);
    precise real reached = first.x + change.depth;
    real2 discharge = water_discharge(reached, real2(first.z, first.w), change);
    precise real x = real(0.5) * (start.z + discharge.x);
    precise real y = real(0.5) * (start.w + discharge.y);
    real2 depth = add_increment(real2(start.x, start.y), gain);
    if (change.rests || depth.x <= real(0)) return real4(depth.x, depth.y, real(0), real(0));
    return real4(depth.x, depth.y, x, y);
}

// Order 1: one Euler step, keeping the depth's low word.
real4 water_euler(real4 water, WaterChange change) {
    real2 depth = add_increment(real2(water.x, water.y), change.depth);
    real2 discharge = water_discharge(depth.x, real2(water.z, water.w), change);
    return real4(depth.x, depth.y, discharge.x, discharge.y);
}

// The fastest wave in a sample along either axis, m/s.
real water_speed(real4 water) {
    real2 velocity = water_velocity(water.x, real2(water.z, water.w));
    precise real square = water_gravity * water.x;
    precise real celerity = sqrt(square);
    precise real speed = max(abs(velocity.x), abs(velocity.y)) + celerity;
    return speed;
}

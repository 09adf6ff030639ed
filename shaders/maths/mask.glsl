// A mask made of the terrain. The including side gives real load_ground(int2), repeating the edge, and
//   cell_m       real2, spacing, metres
//   mask_source  int, of maths/mask_kinds.glsl, which the including side includes
//   mask_low, mask_high  real: from here to there it is 1
//   mask_fade    real: and over so much beyond each it falls to 0
//   mask_rectangle  real4: columns and rows, first and last, for a mask made of the distance from it

// The angle of a tangent of 0 or more, degrees: Abramowitz & Stegun 4.4.49, within 2e-8 of a radian, and above 1 by
// atan(t) = 90° - atan(1 / t).
real mask_angle(real tangent) {
    real t = tangent > real(1) ? real(1) / tangent : tangent;
    precise real s = t * t;
    precise real sum = real(0.0028662257);
    sum = real(-0.0161657367) + s * sum;
    sum = real(0.0429096138) + s * sum;
    sum = real(-0.0752896400) + s * sum;
    sum = real(0.1065626393) + s * sum;
    sum = real(-0.1420889944) + s * sum;
    sum = real(0.1999355085) + s * sum;
    sum = real(-0.3333314528) + s * sum;
    precise real angle = (t + (t * s) * sum) * real(57.295779513082320877);
    precise real rest = real(90) - angle;
    return tangent > real(1) ? rest : angle;
}

// Of the ground, degrees, by central differences.
real mask_slope(int2 at) {
    precise real x = (load_ground(at + int2(1, 0)) - load_ground(at - int2(1, 0))) / (real(2) * cell_m.x);
    precise real y = (load_ground(at + int2(0, 1)) - load_ground(at - int2(0, 1))) / (real(2) * cell_m.y);
    precise real square = x * x + y * y;
    return mask_angle(sqrt(square));
}

real mask_curvature(int2 at) {
    real here = load_ground(at);
    precise real x = ((load_ground(at + int2(1, 0)) - here) + (load_ground(at - int2(1, 0)) - here)) / (cell_m.x * cell_m.x);
    precise real y = ((load_ground(at + int2(0, 1)) - here) + (load_ground(at - int2(0, 1)) - here)) / (cell_m.y * cell_m.y);
    precise real curvature = real(-1000) * (x + y);
    return curvature;
}

// 0 below `from`, 1 above `to`, by a cubic between; a step where they are one.
real mask_step(real value, real from, real to) {
    if (value >= to) return real(1);
    if (value <= from) return real(0);
    precise real s = (value - from) / (to - from);
    precise real step = s * s * (real(3) - real(2) * s);
    return step;
}

real mask_band(real value) {
    real from = mask_low - mask_fade;
    real to = mask_high + mask_fade;
    precise real band = mask_step(value, from, mask_low) * (real(1) - mask_step(value, mask_high, to));
    // Where nothing fades, the upper bound belongs to the band too.
    if (value == mask_high) return mask_step(value, from, mask_low);
    return band;
}

// Metres from the rectangle; 0 within.
real mask_distance(int2 at) {
    real x = max(max(mask_rectangle.x - real(at.x), real(at.x) - mask_rectangle.z), real(0)) * cell_m.x;
    real y = max(max(mask_rectangle.y - real(at.y), real(at.y) - mask_rectangle.w), real(0)) * cell_m.y;
    precise real square = x * x + y * y;
    return sqrt(square);
}

// `layer`: what another layer holds there, of which a mask of the sources after curvature is made; `mask`: what was painted.
real mask_value(int2 at, real layer, real mask) {
    if (mask_source == mask_source_height) return mask_band(load_ground(at));
    if (mask_source == mask_source_slope) return mask_band(mask_slope(at));
    if (mask_source == mask_source_curvature) return mask_band(mask_curvature(at));
    if (mask_source == mask_source_itself) return mask;
    if (mask_source == mask_source_everything) return real(1);
    if (mask_source == mask_source_rectangle) return mask_band(mask_distance(at));
    return mask_band(layer);
}

// How what was painted and what was made become the mask.
real mask_joined(real painted, real made, int join) {
    if (join == mask_join_add) return max(painted, made);
    if (join == mask_join_intersect) return min(painted, made);
    precise real rest = min(painted, real(1) - made);
    return join == mask_join_subtract ? rest : made;
}

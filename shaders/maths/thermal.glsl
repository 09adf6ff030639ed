// Thermal erosion: what stands steeper than its angle of repose slides, as fluxes through faces along the full
// gradient, q = -rate grad h max(0, 1 - S / |grad h|) (docs/numerics.md, "Thermal erosion"). The including side
// gives real4 load_solid(int2) that repeats the edge's samples beyond the edge (walls: no flux leaves), and
//   the numbers of maths/thermal_numbers.glsl
//   load_repose(int2) real, tangent of the angle of repose of the regolith there
//   load_mask(int2)   real, 0 to 1: how far slopes slide there; a face by the lesser of its two sides
#include "maths/solid.glsl"

// Thinner regolith, m, does not slide by itself, so that bare slopes come to rest; regolith as deep as this, m, halves the
// weathering below it.
const real thermal_film = real(1e-5);
const real weathering_depth = real(0.5);

// The share of a slope that is above repose; a face less than 1/4096 above it rests, so that a slope comes to rest in
// finite time.
real slope_excess(real steepness, real repose) {
    precise real excess = real(1) - repose / max(steepness, real(1e-30));
    return steepness > repose * real(1.000244140625) ? excess : real(0);
}

// Metres of solid that slide through a face in one sub-step, from its higher to its lower side; > 0: into `here`.
// `along` is the rise across the face, from `here` to `there`; `beside_0` and `beside_1` are rises along it, each over
// two spacings. The flux is the larger of two: regolith above its angle of repose, a quarter of the higher side's at
// most, and bedrock that fails.
real slide(real along, real spacing, real share, real beside_0, real beside_1, real spacing_beside, real4 here, real4 there, real repose_here, real repose_there) {
    precise real normal = along / spacing;
    precise real tangent = (beside_0 + beside_1) / (real(4) * spacing_beside);
    precise real square = normal * normal + tangent * tangent;
    precise real steepness = sqrt(square);
    real loose = along > real(0) ? there.z : here.z;
    real repose = along > real(0) ? repose_there : repose_here;
    precise real whole = (share / spacing) * along;
    precise real as_regolith = whole * slope_excess(steepness, repose);
    precise real as_bedrock = whole * slope_excess(steepness, bedrock_slope);
    precise real quarter = (loose * real(0.25)) / thermal_bulking;
    real most = loose > thermal_film ? quarter : real(0);
    real limited = min(max(as_regolith, -most), most);
    return abs(as_bedrock) >= abs(limited) ? as_bedrock : limited;
}

// Bedrock that weathers becomes regolith: less the deeper it lies (after Heimsath et al. 1997, as a hyperbola).
real4 weathered(real4 solid, real mask) {
    precise real decay = real(1) + max(solid.z, real(0)) / weathering_depth;
    precise real metres = (weathering_m * mask) / decay;
    precise real loose = metres * thermal_bulking;
    real2 bedrock = add_increment(real2(solid.x, solid.y), -metres);
    real2 regolith = add_increment(real2(solid.z, solid.w), loose);
    return weathering_m > real(0) ? real4(bedrock.x, bedrock.y, regolith.x, regolith.y) : solid;
}

// The sample after one sub-step.
real4 thermal_sample(int2 at) {
    real4 c = load_solid(at);
    real4 n = load_solid(at + int2(0, -1));
    real4 s = load_solid(at + int2(0, 1));
    real4 w = load_solid(at + int2(-1, 0));
    real4 e = load_solid(at + int2(1, 0));
    real4 nw = load_solid(at + int2(-1, -1));
    real4 ne = load_solid(at + int2(1, -1));
    real4 sw = load_solid(at + int2(-1, 1));
    real4 se = load_solid(at + int2(1, 1));

    // Rises southwards over two rows in three columns, eastwards over two columns in three rows.
    real south_w = rise(nw, sw);
    real south_c = rise(n, s);
    real south_e = rise(ne, se);
    real east_n = rise(nw, ne);
    real east_c = rise(w, e);
    real east_s = rise(sw, se);

    real repose_c = load_repose(at);
    real mask_c = load_mask(at);
    precise real share_e = face_share.x * min(mask_c, load_mask(at + int2(1, 0)));
    precise real share_w = face_share.x * min(mask_c, load_mask(at + int2(-1, 0)));
    precise real share_s = face_share.y * min(mask_c, load_mask(at + int2(0, 1)));
    precise real share_n = face_share.y * min(mask_c, load_mask(at + int2(0, -1)));

    // Positive: into this sample. Both sides of a face call slide() with the same bits but for the sign of `along`.
    real from_e = slide(rise(c, e), cell_m.x, share_e, south_c, south_e, cell_m.y, c, e, repose_c, load_repose(at + int2(1, 0)));
    real from_w = slide(rise(c, w), cell_m.x, share_w, south_w, south_c, cell_m.y, c, w, repose_c, load_repose(at + int2(-1, 0)));
    real from_s = slide(rise(c, s), cell_m.y, share_s, east_c, east_s, cell_m.x, c, s, repose_c, load_repose(at + int2(0, 1)));
    real from_n = slide(rise(c, n), cell_m.y, share_n, east_n, east_c, cell_m.x, c, n, repose_c, load_repose(at + int2(0, -1)));

    // Sums go in pairs of opposite faces: a turned terrain gives turned bits.
    precise real gain = (max(from_e, real(0)) + max(from_w, real(0))) + (max(from_s, real(0)) + max(from_n, real(0)));
    precise real loss = (max(-from_e, real(0)) + max(-from_w, real(0))) + (max(-from_s, real(0)) + max(-from_n, real(0)));
    return weathered(exchange_solid(c, gain, loss, thermal_bulking), mask_c);
}

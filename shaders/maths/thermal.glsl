// Thermal erosion: what stands steeper than its angle of repose slides, as fluxes through faces along the full
// gradient, q = -rate grad h max(0, 1 - S / |grad h|) (docs/numerics.md, "Thermal erosion"). The including side
// gives real4 load_solid(int2) that repeats the edge's samples beyond the edge (walls: no flux leaves), and
//   cell_m            real2, spacing of columns and of rows, metres
//   repose_slope      real, tangent of the angle of repose
//   face_share        real2, rate * sub-step / spacing: square metres per second times seconds per metre
#include "maths/solid.glsl"

// Metres of solid that slide through a face in one sub-step, from its higher to its lower side: > 0 into the
// sample on the low side. `along` is the rise across the face, the two others the rises beside it, each over two
// spacings. A face less than 1/4096 above repose rests, so that a slope comes to rest in finite time.
real slide(real along, real spacing, real share, real beside_0, real beside_1, real spacing_beside) {
    precise real normal = along / spacing;
    precise real tangent = (beside_0 + beside_1) / (real(4) * spacing_beside);
    precise real square = normal * normal + tangent * tangent;
    precise real steepness = sqrt(square);
    precise real excess = real(1) - repose_slope / max(steepness, real(1e-30));
    precise real amount = (share / spacing) * (along * excess);
    return steepness > repose_slope * real(1.000244140625) ? amount : real(0);
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

    // Positive: into this sample. Both sides of a face call slide() with the same bits but for the sign of `along`.
    real from_e = slide(rise(c, e), cell_m.x, face_share.x, south_c, south_e, cell_m.y);
    real from_w = slide(rise(c, w), cell_m.x, face_share.x, south_w, south_c, cell_m.y);
    real from_s = slide(rise(c, s), cell_m.y, face_share.y, east_c, east_s, cell_m.x);
    real from_n = slide(rise(c, n), cell_m.y, face_share.y, east_n, east_c, cell_m.x);

    // Sums go in pairs of opposite faces: a turned terrain gives turned bits.
    precise real gain = (max(from_e, real(0)) + max(from_w, real(0))) + (max(from_s, real(0)) + max(from_n, real(0)));
    precise real loss = (max(-from_e, real(0)) + max(-from_w, real(0))) + (max(-from_s, real(0)) + max(-from_n, real(0)));
    return exchange_solid(c, gain, loss);
}

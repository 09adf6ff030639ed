// How strongly a dab acts at a place. The including side gives the numbers of maths/dab_numbers.glsl and real
// load_mask(int2), how far the mask lets it act, 0 to 1.

// 1 in the middle, 0 at the radius and beyond.
real brush_weight(real2 offset_m) {
    precise real square = offset_m.x * offset_m.x + offset_m.y * offset_m.y;
    precise real distance_m = sqrt(square);
    precise real edge = (dab_radius_m - distance_m) / max(dab_radius_m * dab_falloff, real(1e-30));
    precise real s = min(max(edge, real(0)), real(1));
    precise real weight = s * s * (real(3) - real(2) * s);
    if (dab_curve == falloff_linear) weight = s;
    if (dab_curve == falloff_round) {
        precise real square_left = s * (real(2) - s);
        weight = sqrt(square_left);
    }
    if (dab_curve == falloff_sharp) weight = s * s;
    return distance_m < dab_radius_m ? weight : real(0);
}

// Metres from the dab's centre to a sample (column, row).
real2 dab_offset_m(int2 at) {
    int2 cells = at - dab_sample;
    precise real x = (real(cells.x) - dab_offset.x) * cell_m.x;
    precise real y = (real(cells.y) - dab_offset.y) * cell_m.y;
    return real2(x, y);
}

// How far along the dab's line the place beside it is, 0 to 1.
real dab_along(real2 offset_m) {
    precise real along = offset_m.x * dab_length_m.x + offset_m.y * dab_length_m.y;
    precise real square = dab_length_m.x * dab_length_m.x + dab_length_m.y * dab_length_m.y;
    precise real share = along / max(square, real(1e-30));
    return min(max(share, real(0)), real(1));
}

real brush_weight_at(int2 at) {
    real2 offset_m = dab_offset_m(at);
    real along = dab_along(offset_m);
    precise real x = offset_m.x - along * dab_length_m.x;
    precise real y = offset_m.y - along * dab_length_m.y;
    precise real weight = brush_weight(real2(x, y)) * load_mask(at);
    return weight;
}

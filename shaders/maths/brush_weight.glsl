// How strongly a dab acts at a place. The including side gives dab_radius_m and dab_falloff (maths/brush.glsl).

// 1 in the middle, 0 at the radius and beyond, by a cubic between.
real brush_weight(real2 offset_m) {
    precise real square = offset_m.x * offset_m.x + offset_m.y * offset_m.y;
    precise real distance_m = sqrt(square);
    precise real edge = (dab_radius_m - distance_m) / max(dab_radius_m * dab_falloff, real(1e-30));
    precise real s = min(max(edge, real(0)), real(1));
    precise real weight = s * s * (real(3) - real(2) * s);
    return distance_m < dab_radius_m ? weight : real(0);
}

// The same at a sample; dab_sample and dab_offset say where the dab's centre is, cell_m the spacing.
real brush_weight_at(int2 at) {
    int2 cells = at - dab_sample;
    precise real x = (real(cells.x) - dab_offset.x) * cell_m.x;
    precise real y = (real(cells.y) - dab_offset.y) * cell_m.y;
    return brush_weight(real2(x, y));
}

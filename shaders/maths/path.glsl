// A path of a dab: level across a width along a line of points, with slopes beside it (docs/numerics.md, "Brush"). Needs
// maths/rise.glsl, the numbers of maths/dab_numbers.glsl, and
//   real3 load_path(int), a point: metres from the dab's centre (column, row), and above the dab's target

// Where the line is nearest to a place: how far away, m, and how high the path is there, above the target.
real2 path_nearest(real2 offset_m) {
    real nearest = real(1e30);
    real height = real(0);
    real3 a = load_path(0);
    for (int i = 1; i < path_points; ++i) {
        real3 b = load_path(i);
        precise real dx = b.x - a.x;
        precise real dy = b.y - a.y;
        precise real ox = offset_m.x - a.x;
        precise real oy = offset_m.y - a.y;
        precise real share = (ox * dx + oy * dy) / max(dx * dx + dy * dy, real(1e-30));
        real along = min(max(share, real(0)), real(1));
        precise real vx = ox - along * dx;
        precise real vy = oy - along * dy;
        precise real square = vx * vx + vy * vy;
        precise real level = a.z + along * (b.z - a.z);
        height = square < nearest ? level : height;
        nearest = min(nearest, square);
        a = b;
    }
    precise real distance_m = sqrt(nearest);
    return real2(distance_m, height);
}

// Metres that the path adds to the ground there. `to_target`: from the ground to the dab's target.
real path_change(real2 offset_m, real to_target) {
    real2 nearest = path_nearest(offset_m);
    if (nearest.x >= dab_radius_m) return real(0);
    precise real beside = max(nearest.x - path_half_width_m, real(0));
    precise real level = to_target + nearest.y;
    precise real least = level - beside * path_fill_slope;
    precise real most = level + beside * path_cut_slope;
    real filled = path_fills == 1 ? max(least, real(0)) : real(0);
    return path_cuts == 1 ? min(filled, most) : filled;
}

// The surface between four samples: a bilinear patch, for every method (law 1). Corners are
// real4(z00, z10, z01, z11): first index the column, second the row.

// Exact at both ends: w = 0 gives a, w = 1 gives b, to the bit.
real along_edge(real a, real b, real w) {
    return w < real(0.5) ? a + w * (b - a) : b - (real(1) - w) * (b - a);
}

// Height at (u, v) in 0 to 1. On an edge it is along_edge() of that edge's two corners: neighbours agree there.
real patch_height(real4 z, real2 at) {
    return along_edge(along_edge(z.x, z.y, at.x), along_edge(z.z, z.w, at.x), at.y);
}

// Distance from a patch's entry to the first place where a ray goes from above to below it, by the quadratic of
// Park & Oh 2009, figure 7, equation 1, written from the entry: above(s) = c0 + c1 s + c2 s^2.
//   entry      u, v of the entry; direction: patches per metre (u, v) and metres per metre (z)
//   above_in   height over the surface at the entry, > 0; above_out: at the exit; span: distance to the exit
// Negative: no hit. A hit that the signs at both ends prove is never lost to rounding: it is clamped into the span.
real patch_hit(real4 z, real2 entry, real3 direction, real above_in, real above_out, real span) {
    real b = z.y - z.x;
    real c = z.z - z.x;
    real a = (z.w - z.z) - b;
    real c1 = direction.z - (b * direction.x + c * direction.y + a * (entry.x * direction.y + entry.y * direction.x));
    real c2 = -a * (direction.x * direction.y);
    real discriminant = c1 * c1 - real(4) * (c2 * above_in);
    real root = sqrt(max(discriminant, real(0)));
    // The first crossing downwards; of the two equal forms the one that does not cancel.
    real s = c1 <= real(0) ? real(2) * above_in / max(root - c1, real(1e-30)) : (c1 + root) / max(real(-2) * c2, real(1e-30));
    if (above_out < real(0)) return min(max(s, real(0)), span);
    bool dips = discriminant >= real(0) && c2 > real(0) && c1 < real(0) && -c1 < real(2) * (c2 * span);
    return dips ? min(s, span) : real(-1);
}

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

struct PatchCast {
    real distance_m;  // of the hit along the ray; < 0: none
    real leave_m;     // where the ray leaves the patch
    real above_out;   // its height over the patch there
    bool by_x;        // through the plane to the next column, else to the next row
};

real cast_inverse(real d) {
    real size = max(abs(d), real(1e-20));
    return d < real(0) ? real(-1) / size : real(1) / size;
}

// Distances along a ray to a plane between columns and to one between rows, counted from the ray's origin cell; fraction
// and inverse as below. All planes' distances are this expression, so that equal planes compare equal.
real2 cast_planes(int2 planes, real2 fraction, real2 inverse) { return (real2(planes) - fraction) * inverse; }

// A ray's hit in one patch: signs at entry and exit decide, the quadratic says where.
//   z          corners over the ray's start; offset: the patch's column and row from the ray's origin cell
//   fraction   where in that cell the ray starts; direction: columns, rows and metres of height per metre of ray
//   inverse    cast_inverse() of the direction's columns and rows; side: 1 where it runs to higher indices, else 0
//   begin      where on the ray the ground begins to count
// The ground is solid: a ray below the patch where it enters hits there.
PatchCast cast_patch(real4 z, int2 offset, real2 fraction, real3 direction, real2 inverse, int2 side, real begin) {
    real2 near = cast_planes(offset + 1 - side, fraction, inverse);
    real2 far = cast_planes(offset + side, fraction, inverse);
    real enter = max(max(near.x, near.y), begin);
    real leave = max(min(far.x, far.y), enter);
    // Where a plane is crossed, its coordinate is 0 or 1 to the bit, so both patches read the same edge.
    real in_u = enter == near.x ? real(1 - side.x) : (fraction.x + enter * direction.x) - real(offset.x);
    real in_v = enter == near.y ? real(1 - side.y) : (fraction.y + enter * direction.y) - real(offset.y);
    real out_u = leave == far.x ? real(side.x) : (fraction.x + leave * direction.x) - real(offset.x);
    real out_v = leave == far.y ? real(side.y) : (fraction.y + leave * direction.y) - real(offset.y);
    real2 entry = real2(min(max(in_u, real(0)), real(1)), min(max(in_v, real(0)), real(1)));
    real2 exit = real2(min(max(out_u, real(0)), real(1)), min(max(out_v, real(0)), real(1)));
    real above_in = direction.z * enter - patch_height(z, entry);
    real above_out = direction.z * leave - patch_height(z, exit);
    real s = above_in <= real(0) ? real(0) : patch_hit(z, entry, direction, above_in, above_out, leave - enter);
    PatchCast hit;
    hit.distance_m = s >= real(0) ? enter + s : real(-1);
    hit.leave_m = leave;
    hit.above_out = above_out;
    hit.by_x = far.x <= far.y;
    return hit;
}

// Casts a ray through the max pyramid onto the bilinear surface (Park & Oh 2009; Dick et al. 2009, section 3.2;
// docs/numerics.md, "Exact casting"). Columns u and rows v are counted from the ray's origin cell, heights from the
// ray's origin height, so nothing cancels far from the terrain's corner. The including side gives
//   real load_top(int2 cell, int level)     highest corner of a pyramid cell, level >= 1, over the origin height
//   real load_highest()                     highest sample of all, over the origin height
//   real4 load_corners(int2 patch)          its four samples over the origin height
//   patches     int2, number of patches (columns - 1, rows - 1)
//   top_level   int, the coarsest level of the pyramid
//   count_steps bool, a constant: false where nobody reads the steps of the walk, which cost a quarter of the time
#include "maths/patch.glsl"

struct CastHit {
    real distance_m;  // along the ray; < 0: nothing hit
    int2 cell;        // the patch that was hit
    int steps;        // patches visited, and with count_steps the pyramid's cells too
};

// Beyond this many something is wrong: a ray crosses fewer than 4 * (columns + rows) cells of any pyramid, and every
// step of the walk gets on.
const int cast_step_limit = 131072;

real cast_inverse(real d) {
    real size = max(abs(d), real(1e-20));
    return d < real(0) ? real(-1) / size : real(1) / size;
}

// origin_cell + fraction: where the ray starts, in columns and rows; direction: columns, rows and metres of height
// per metre of ray; from_m: where on the ray to start looking; start_level: where in the pyramid, 3 or more; height_m:
// where the ray starts over the origin height.
// The ground is solid: a ray that starts below it, or enters its side below it, hits there.
CastHit cast_ray(int2 origin_cell, real2 fraction, real3 direction, real from_m, int start_level, real height_m) {
    CastHit hit;
    hit.distance_m = real(-1);
    hit.cell = int2(0, 0);
    hit.steps = 0;

    real2 inverse = real2(cast_inverse(direction.x), cast_inverse(direction.y));
    real inverse_z = cast_inverse(direction.z);
    // 1 where the ray runs towards higher indices: the offset from a cell to its far plane.
    int2 side = int2(direction.x < real(0) ? 0 : 1, direction.y < real(0) ? 0 : 1);
    int2 forward = int2(2 * side.x - 1, 2 * side.y - 1);

    // Into the terrain's rectangle. Every plane's distance is this same expression, so that equal planes compare equal.
    int2 near_edge = int2(side.x == 1 ? 0 : patches.x, side.y == 1 ? 0 : patches.y);
    int2 far_edge = int2(patches.x - near_edge.x, patches.y - near_edge.y);
    real enter_x = (real(near_edge.x - origin_cell.x) - fraction.x) * inverse.x;
    real enter_y = (real(near_edge.y - origin_cell.y) - fraction.y) * inverse.y;
    real leave_x = (real(far_edge.x - origin_cell.x) - fraction.x) * inverse.x;
    real leave_y = (real(far_edge.y - origin_cell.y) - fraction.y) * inverse.y;
    real begin = max(max(enter_x, enter_y), from_m);
    real end = min(leave_x, leave_y);
    // And below its highest sample.
    real crossing = (load_highest() - height_m) * inverse_z;
    begin = direction.z < real(0) ? max(begin, crossing) : begin;
    end = direction.z < real(0) ? end : min(end, crossing);

    // A cell's lowest point of the ray is where it leaves, going down, or where it enters. As factors, not selects.
    real down = direction.z < real(0) ? direction.z : real(0);
    real up_or_level = direction.z < real(0) ? real(0) : direction.z;
    real fall = direction.z < real(0) ? inverse_z : real(-1e30);

    // An eye among the mountains meets ground soon; from above, most of the way is empty.
    int level = min(begin > from_m ? start_level : start_level - 2, top_level);
    int2 cell = int2(origin_cell.x + int(floor(fraction.x + begin * direction.x)),
                     origin_cell.y + int(floor(fraction.y + begin * direction.y)));
    cell = int2(min(max(cell.x, 0), patches.x - 1) >> level, min(max(cell.y, 0), patches.y - 1) >> level);
    real at = begin;
    bool inside = begin <= end;

    // Loops test at their end: llvmpipe runs a body once more, masked, for a test at the top.
    do {
        // Walk the pyramid down to a patch that the ray may meet. Selects instead of branches: lanes stay together.
        do {
            if (count_steps) hit.steps += 1;
            real top = load_top(cell, level) - height_m;
            int2 far_plane = int2((cell.x + side.x) << level, (cell.y + side.y) << level);
            real far_x = (real(far_plane.x - origin_cell.x) - fraction.x) * inverse.x;
            real far_y = (real(far_plane.y - origin_cell.y) - fraction.y) * inverse.y;
            real leave = min(far_x, far_y);
            bool descend = leave * down + at * up_or_level <= top;

            // Down: to the half that the ray is in when it has come down to the cell's top.
            real drop = max(at, top * fall);
            int half_cell = (1 << level) >> 1;
            int2 middle = int2(far_plane.x + (side.x == 1 ? -half_cell : half_cell),
                               far_plane.y + (side.y == 1 ? -half_cell : half_cell));
            real middle_x = (real(middle.x - origin_cell.x) - fraction.x) * inverse.x;
            real middle_y = (real(middle.y - origin_cell.y) - fraction.y) * inverse.y;
            int2 child = int2(2 * cell.x + (drop >= middle_x ? side.x : 1 - side.x),
                              2 * cell.y + (drop >= middle_y ? side.y : 1 - side.y));

            // On: to the next cell, one level up where that lies in another parent.
            bool by_x = far_x <= far_y;
            int2 next = int2(cell.x + (by_x ? forward.x : 0), cell.y + (by_x ? 0 : forward.y));
            int up = level < top_level && ((by_x ? cell.x : cell.y) & 1) == (by_x ? side.x : side.y) ? 1 : 0;

            at = descend ? drop : leave;
            cell = int2(descend ? child.x : next.x >> up, descend ? child.y : next.y >> up);
            level = at < end ? level + (descend ? -1 : up) : -1;  // -1: beyond the terrain
        } while (level > 0);

        inside = level == 0;
        if (inside) {
            // The patch: signs at entry and exit decide, the quadratic says where.
            hit.steps += 1;
            real4 z = load_corners(cell) - real4(height_m, height_m, height_m, height_m);
            int2 offset = int2(cell.x - origin_cell.x, cell.y - origin_cell.y);
            real near_x = (real(offset.x + 1 - side.x) - fraction.x) * inverse.x;
            real near_y = (real(offset.y + 1 - side.y) - fraction.y) * inverse.y;
            real far_x = (real(offset.x + side.x) - fraction.x) * inverse.x;
            real far_y = (real(offset.y + side.y) - fraction.y) * inverse.y;
            real enter = max(max(near_x, near_y), begin);
            real leave = max(min(far_x, far_y), enter);
            // Where a plane is crossed, its coordinate is 0 or 1 to the bit, so both patches read the same edge.
            real in_u = enter == near_x ? real(1 - side.x) : (fraction.x + enter * direction.x) - real(offset.x);
            real in_v = enter == near_y ? real(1 - side.y) : (fraction.y + enter * direction.y) - real(offset.y);
            real out_u = leave == far_x ? real(side.x) : (fraction.x + leave * direction.x) - real(offset.x);
            real out_v = leave == far_y ? real(side.y) : (fraction.y + leave * direction.y) - real(offset.y);
            real2 entry = real2(min(max(in_u, real(0)), real(1)), min(max(in_v, real(0)), real(1)));
            real2 exit = real2(min(max(out_u, real(0)), real(1)), min(max(out_v, real(0)), real(1)));
            real above_in = direction.z * enter - patch_height(z, entry);
            real above_out = direction.z * leave - patch_height(z, exit);
            real s = above_in <= real(0) ? real(0) : patch_hit(z, entry, direction, above_in, above_out, leave - enter);
            hit.distance_m = s >= real(0) ? enter + s : real(-1);
            hit.cell = cell;

            // On from its parent, whose other patches are then chosen by the distance reached.
            bool by_x = far_x <= far_y;
            cell = int2((cell.x + (by_x ? forward.x : 0)) >> 1, (cell.y + (by_x ? 0 : forward.y)) >> 1);
            at = leave;
            level = 1;
            inside = s < real(0) && at < end && hit.steps < cast_step_limit;
        }
    } while (inside);
    return hit;
}

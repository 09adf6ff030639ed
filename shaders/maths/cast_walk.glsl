// Walks a ray through a max pyramid onto the bilinear surface (Park & Oh 2009; Dick et al. 2009, section 3.2;
// docs/numerics.md, "Exact casting"). Columns u and rows v are counted from the ray's origin cell, heights from the
// ray's origin height, so nothing cancels far from the terrain's corner. The including side gives
//   real load_top(int2 cell, int level)     highest corner of a pyramid cell, level >= 1, over the origin height
//   real4 load_corners(int2 patch)          its four samples over the origin height
//   count_steps bool, a constant: false where nobody reads the steps of the walk, which cost a quarter of the time
#include "maths/patch.glsl"

struct CastHit {
    real distance_m;  // along the ray; < 0: nothing hit
    int steps;        // patches visited, and with count_steps the pyramid's cells too
};

// Beyond this many something is wrong: a ray crosses fewer than 4 * (columns + rows) cells of the pyramid that it walks, and every
// step of the walk gets on.
const int cast_step_limit = 131072;

// Where a ray is over or under a rectangle, from one plane between columns and rows to another, and below a height over its
// start: from where to where, m along it; an end before the beginning: nowhere. Parameters as below and in maths/patch.glsl.
real2 cast_span(int2 first, int2 last, real top_m, int2 origin_cell, real2 fraction, real3 direction, real2 inverse, real inverse_z, int2 side) {
    int2 near_edge = int2(side.x == 1 ? first.x : last.x, side.y == 1 ? first.y : last.y);
    int2 far_edge = int2(side.x == 1 ? last.x : first.x, side.y == 1 ? last.y : first.y);
    real2 enter = cast_planes(near_edge - origin_cell, fraction, inverse);
    real2 leave = cast_planes(far_edge - origin_cell, fraction, inverse);
    real begin = max(max(enter.x, enter.y), real(0));
    real end = min(leave.x, leave.y);
    real crossing = top_m * inverse_z;
    return direction.z < real(0) ? real2(max(begin, crossing), end) : real2(begin, min(end, crossing));
}

// The column and row where a ray is at a distance, 0 to `last`: by its planes, which rounding leaves in
// order. The floor of a place may be the patch beside it.
int2 cast_cell(real at, int2 last, int2 origin_cell, real2 fraction, real3 direction, real2 inverse, int2 side) {
    int2 cell = int2(int(floor(fraction.x + at * direction.x)), int(floor(fraction.y + at * direction.y)));
    real2 near = cast_planes(int2(cell.x + 1 - side.x, cell.y + 1 - side.y), fraction, inverse);
    real2 far = cast_planes(int2(cell.x + side.x, cell.y + side.y), fraction, inverse);
    int step_x = at < near.x ? -1 : at >= far.x ? 1 : 0;
    int step_y = at < near.y ? -1 : at >= far.y ? 1 : 0;
    cell = int2(origin_cell.x + cell.x + (side.x == 1 ? step_x : -step_x), origin_cell.y + cell.y + (side.y == 1 ? step_y : -step_y));
    return int2(min(max(cell.x, 0), last.x), min(max(cell.y, 0), last.y));
}

// The walk of a ray from one distance to another, m along it, through the pyramid to the first patch that it hits.
// origin_cell + fraction: where the ray starts, in columns and rows; direction: columns, rows and metres of height
// per metre of ray; inverse, inverse_z: cast_inverse() of it; side: 1 where it runs towards higher indices, else 0;
// begin: where the ground begins to count; walk_patches, walk_top_level: how many patches there are, and the coarsest level over
// them; from_m: before it no ground is met, 0 where nothing is known; start_level: where in the pyramid to start; height_m:
// where the ray starts over the origin height.
CastHit cast_walk(real begin, real end, int2 origin_cell, real2 fraction, real3 direction, real2 inverse, real inverse_z, int2 side, int2 walk_patches, int walk_top_level, real from_m, int start_level, real height_m) {
    CastHit hit;
    hit.distance_m = real(-1);
    hit.steps = 0;
    int2 forward = int2(2 * side.x - 1, 2 * side.y - 1);

    // A cell's lowest point of the ray is where it leaves, going down, or where it enters. As factors, not selects.
    real down = direction.z < real(0) ? direction.z : real(0);
    real up_or_level = direction.z < real(0) ? real(0) : direction.z;
    real fall = direction.z < real(0) ? inverse_z : real(-1e30);

    // A walk that starts further on changes no bit of the hit: patches still count from the beginning.
    real at = max(begin, from_m);
    int level = min(start_level, walk_top_level);
    // Where the walk would start beyond the end, it ends at once: from a cell that there is.
    int2 cell = cast_cell(min(at, end), int2(walk_patches.x - 1, walk_patches.y - 1), origin_cell, fraction, direction, inverse, side);
    cell = int2(cell.x >> level, cell.y >> level);
    bool inside = at <= end;

    // Loops test at their end: llvmpipe runs a body once more, masked, for a test at the top.
    do {
        // Walk the pyramid down to a patch that the ray may meet. Selects instead of branches: lanes stay together.
        do {
            if (count_steps) hit.steps += 1;
            real top = load_top(cell, level) - height_m;
            int2 far_plane = int2((cell.x + side.x) << level, (cell.y + side.y) << level);
            real2 far = cast_planes(far_plane - origin_cell, fraction, inverse);
            real leave = min(far.x, far.y);
            bool descend = leave * down + at * up_or_level <= top;

            // Down: to the half that the ray is in when it has come down to the cell's top.
            real drop = max(at, top * fall);
            int half_cell = (1 << level) >> 1;
            int2 middle = int2(far_plane.x + (side.x == 1 ? -half_cell : half_cell),
                               far_plane.y + (side.y == 1 ? -half_cell : half_cell));
            real2 halfway = cast_planes(middle - origin_cell, fraction, inverse);
            int2 child = int2(2 * cell.x + (drop >= halfway.x ? side.x : 1 - side.x),
                              2 * cell.y + (drop >= halfway.y ? side.y : 1 - side.y));

            // On: to the next cell, one level up where that lies in another parent.
            bool by_x = far.x <= far.y;
            int2 next = int2(cell.x + (by_x ? forward.x : 0), cell.y + (by_x ? 0 : forward.y));
            int up = level < walk_top_level && ((by_x ? cell.x : cell.y) & 1) == (by_x ? side.x : side.y) ? 1 : 0;

            at = descend ? drop : leave;
            cell = int2(descend ? child.x : next.x >> up, descend ? child.y : next.y >> up);
            level = at < end ? level + (descend ? -1 : up) : -1;  // -1: beyond the terrain
        } while (level > 0);

        inside = level == 0;
        if (inside) {
            hit.steps += 1;
            real4 z = load_corners(cell) - real4(height_m, height_m, height_m, height_m);
            int2 offset = int2(cell.x - origin_cell.x, cell.y - origin_cell.y);
            PatchCast here = cast_patch(z, offset, fraction, direction, inverse, side, begin);
            hit.distance_m = here.distance_m;

            // On from its parent, whose other patches are then chosen by the distance reached.
            cell = int2((cell.x + (here.by_x ? forward.x : 0)) >> 1, (cell.y + (here.by_x ? 0 : forward.y)) >> 1);
            at = here.leave_m;
            level = 1;
            inside = hit.distance_m < real(0) && at < end && hit.steps < cast_step_limit;
        }
    } while (inside);
    return hit;
}

// Casts a ray onto a terrain in tiles of several levels of detail (Dick, Krueger & Westermann 2009, sections 3 and 4;
// docs/numerics.md, "Tiled terrain"). A walk over the tree of tiles, from near to far, finds the tiles that the ray may
// meet; in each one it goes on as in maths/cast_walk.glsl, over the samples of the tile's own level. A tile's sides are solid, so
// a ray that comes from a coarser tile into a finer one below its surface hits there. All tiles' edges are planes between columns
// and rows of the finest level, and their distances are one expression: no ray passes between two tiles, and where all
// tiles are of the finest level, the hits are those of cast_ray(), bit for bit. The including side gives, besides what
// maths/cast_walk.glsl needs of the tile that it loaded last,
//   real2 load_tile_node(int2 tile, int level)   its highest point over the origin height, and its slot; -1: its four tiles
//                                                of the level below are drawn instead; -2: a tile that it lies in is
//   TilePlace load_tile(int slot)                (maths/tile_place.glsl) where the eye is among the samples of the tile in a
//                                                slot; load_top() and load_corners() are that tile's from then on
//   real load_highest()   highest sample of all, over the origin height
//   patches          int2, of the finest level
//   tile_side_level  int, a tile of the finest level has 2 to the power of it patches in a row
//   tile_top_level   int, the coarsest level of the tree
//   room_patches     int2, patches that a slot holds in a row and in a column
//   slot_walk_level  int, the coarsest level of a slot's pyramid that rays walk up to: slot_top_level, but in benchmarks
//   cast_once        bool, a constant: whether a ray ends at its first hit: true, but in benchmarks
#include "maths/cast_walk.glsl"

// A ray crosses fewer tiles of all levels together; beyond it something is wrong.
const int tile_step_limit = 65536;

struct TileHit {
    real distance_m;  // along the ray; < 0: nothing hit
    int steps;        // of both walks
    int slot;         // of the tile that was hit
    bool on_wall;     // where the distances in which ground counts begin
};

// A walk through a tile that a ray comes into from another one starts at this level of its pyramid.
const int tile_entry_level = 4;

// Parameters as of cast_ray(), of the finest level. start_level: where in a pyramid over it to start; its levels from the size of
// the finest tiles on are the tree's, but none finer than first_tile_level. within: distances between which ground counts; a ray
// that is below it at the first hits there.
TileHit cast_tiles(int2 origin_cell, real2 fraction, real3 direction, real from_m, int start_level, int first_tile_level, real height_m,
                   real2 within) {
    TileHit hit;
    hit.distance_m = real(-1);
    hit.steps = 0;
    hit.slot = 0;
    hit.on_wall = false;

    real2 inverse = real2(cast_inverse(direction.x), cast_inverse(direction.y));
    real inverse_z = cast_inverse(direction.z);
    int2 side = int2(direction.x < real(0) ? 0 : 1, direction.y < real(0) ? 0 : 1);
    int2 forward = int2(2 * side.x - 1, 2 * side.y - 1);
    real2 span = cast_span(int2(0, 0), patches, load_highest() - height_m, origin_cell, fraction, direction, inverse, inverse_z, side);
    span = real2(max(span.x, within.x), min(span.y, within.y));
    real end = span.y;
    real down = direction.z < real(0) ? direction.z : real(0);
    real up_or_level = direction.z < real(0) ? real(0) : direction.z;
    real fall = direction.z < real(0) ? inverse_z : real(-1e30);

    real at = max(span.x, from_m);
    int level = min(max(start_level - tile_side_level, first_tile_level), tile_top_level);
    int entry_level = start_level;
    int2 cell = cast_cell(min(at, end), int2(patches.x - 1, patches.y - 1), origin_cell, fraction, direction, inverse, side);
    cell = int2(cell.x >> (tile_side_level + level), cell.y >> (tile_side_level + level));
    bool inside = at <= end;

    do {
        // Walk the tree down to a tile that is drawn and that the ray may meet.
        // What is used behind the loop hangs on its value of the turn before: llvmpipe gives lanes that left a loop what
        // others find in later turns, if it does not (docs/devices.md).
        int slot = -1;
        bool walking = true;
        int turns = 0;
        do {
            if (count_steps) hit.steps += 1;
            turns += 1;
            real2 node = load_tile_node(cell, level);
            real top = node.x - height_m;
            int across = 1 << (tile_side_level + level);
            int2 far_plane = int2((cell.x + side.x) * across, (cell.y + side.y) * across);
            real2 far = cast_planes(far_plane - origin_cell, fraction, inverse);
            real leave = min(far.x, far.y);
            bool below = leave * down + at * up_or_level <= top;
            bool found = below && node.y >= real(0);
            // Beside finer tiles a coarser one may be drawn.
            bool ascend = node.y < real(-1.5);
            slot = found ? int(node.y) : slot;
            bool descend = below && !found;

            real drop = max(at, top * fall);
            int half_across = across >> 1;
            int2 middle = int2(far_plane.x + (side.x == 1 ? -half_across : half_across),
                               far_plane.y + (side.y == 1 ? -half_across : half_across));
            real2 halfway = cast_planes(middle - origin_cell, fraction, inverse);
            int2 child = int2(2 * cell.x + (drop >= halfway.x ? side.x : 1 - side.x),
                              2 * cell.y + (drop >= halfway.y ? side.y : 1 - side.y));
            bool by_x = far.x <= far.y;
            int2 next = int2(cell.x + (by_x ? forward.x : 0), cell.y + (by_x ? 0 : forward.y));
            int up = level < tile_top_level && ((by_x ? cell.x : cell.y) & 1) == (by_x ? side.x : side.y) ? 1 : 0;

            at = found || ascend ? at : descend ? drop : leave;
            cell = found ? cell : ascend ? int2(cell.x >> 1, cell.y >> 1) : int2(descend ? child.x : next.x >> up, descend ? child.y : next.y >> up);
            level = found ? level : level + (ascend ? 1 : descend ? -1 : up);
            walking = !found && at < end && turns < tile_step_limit;
        } while (walking);

        inside = slot >= 0;
        hit.slot = inside && hit.distance_m < real(0) ? slot : hit.slot;
        if (inside) {
            TilePlace place = load_tile(slot);
            int across = 1 << (tile_side_level + level);
            int2 near_plane = int2((cell.x + 1 - side.x) * across, (cell.y + 1 - side.y) * across);
            int2 far_plane = int2((cell.x + side.x) * across, (cell.y + side.y) * across);
            real2 near = cast_planes(near_plane - origin_cell, fraction, inverse);
            real2 far = cast_planes(far_plane - origin_cell, fraction, inverse);
            real begin = max(max(near.x, near.y), span.x);
            real leave = min(far.x, far.y);
            real tile_end = min(leave, end);
            real3 tile_direction = real3(direction.x * place.scale.x, direction.y * place.scale.y, direction.z);
            real2 tile_inverse = real2(cast_inverse(tile_direction.x), cast_inverse(tile_direction.y));
            CastHit here = cast_walk(begin, tile_end, place.origin_cell, place.fraction, tile_direction, tile_inverse, inverse_z, side,
                                     room_patches, slot_walk_level, at, max(entry_level - place.level, 1), height_m);
            entry_level = tile_entry_level + place.level;
            // A patch of a coarser level reaches beyond the tile's edge; what is hit there belongs to the next tile.
            bool beyond = place.level > 0 && here.distance_m > tile_end;
            hit.distance_m = hit.distance_m >= real(0) ? hit.distance_m : beyond ? real(-1) : here.distance_m;
            hit.steps += here.steps;

            bool by_x = far.x <= far.y;
            int2 next = int2(cell.x + (by_x ? forward.x : 0), cell.y + (by_x ? 0 : forward.y));
            int up = level < tile_top_level && ((by_x ? cell.x : cell.y) & 1) == (by_x ? side.x : side.y) ? 1 : 0;
            cell = int2(next.x >> up, next.y >> up);
            level += up;
            at = leave;
            inside = (hit.distance_m < real(0) || !cast_once) && at < end && hit.steps < cast_step_limit;
        }
    } while (inside);
    hit.on_wall = hit.distance_m >= real(0) && hit.distance_m <= within.x;
    return hit;
}

// The same where the ground has a hole, of patches from `first` to before `end`: up to where the ray comes over it, then from where
// it has passed it. Its sides are walls: a ray that passed it below the ground hits there.
TileHit cast_tiles_around(int2 first, int2 end, int2 origin_cell, real2 fraction, real3 direction, real from_m, int start_level,
                          int first_tile_level, real height_m) {
    real2 inverse = real2(cast_inverse(direction.x), cast_inverse(direction.y));
    int2 side = int2(direction.x < real(0) ? 0 : 1, direction.y < real(0) ? 0 : 1);
    int2 near_edge = int2(side.x == 1 ? first.x : end.x, side.y == 1 ? first.y : end.y);
    int2 far_edge = int2(side.x == 1 ? end.x : first.x, side.y == 1 ? end.y : first.y);
    real2 enter = cast_planes(near_edge - origin_cell, fraction, inverse);
    real2 leave = cast_planes(far_edge - origin_cell, fraction, inverse);
    real2 gap = real2(max(enter.x, enter.y), min(leave.x, leave.y));
    bool meets = gap.x < gap.y && gap.y > real(0);

    TileHit hit;
    hit.distance_m = real(-1);
    hit.steps = 0;
    hit.slot = 0;
    hit.on_wall = false;
    int part = 0;
    bool going = true;
    do {
        real2 within = real2(part == 0 ? real(0) : gap.y, part == 0 && meets ? gap.x : real(1e30));
        TileHit here = cast_tiles(origin_cell, fraction, direction, from_m, start_level, first_tile_level, height_m, within);
        hit.distance_m = going ? here.distance_m : hit.distance_m;
        hit.steps += going ? here.steps : 0;
        hit.slot = going ? here.slot : hit.slot;
        hit.on_wall = going ? here.on_wall && part == 1 : hit.on_wall;
        part += 1;
        going = going && meets && hit.distance_m < real(0) && part < 2;
    } while (going);
    return hit;
}

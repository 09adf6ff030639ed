// How far a bundle of rays from one point may go before any of them can meet ground: a walk over blocks of 2 x 2 cells of
// the max pyramid (docs/numerics.md, "Beams"). Everything grows linearly with depth: a ray of the bundle is, at depth w,
// within spread * w of middle * w, in columns, rows and metres of height. The including side gives load_highest(), patches
// and top_level as for maths/cast.glsl, and of a block of 2 x 2 cells of a pyramid over the patches, from its first on:
//   real block_top(int2 cell, int level)      over the origin height, no ground in it is higher; far below beside the terrain
//   real block_bottom(int2 cell, int level)   none is lower; with flat_ends alone

struct Beam {
    real depth;     // no ray of the bundle meets ground before it
    int level;      // of the cells where it stopped; 0: none meets ground at all
    bool flat_end;  // all rays end in cells so flat that one height tells their hits
    real height_m;  // that height over the origin's, where flat_end
};

// Beyond so many steps the bundle stops where it is: a shorter way is still a right one.
const int beam_step_limit = 96;

// Where an edge of the bundle reaches a plane, going that way; a great depth where it never does.
real beam_reach(real way, real speed) { return speed > real(0) ? way / speed : real(1e30); }

// A block of 2 x 2 cells about the bundle at a depth.
struct BeamBlock {
    int2 cell;   // its first
    real leave;  // the depth where an edge of the bundle leaves it
    real top;    // its highest point
    bool fits;   // the bundle lies in it and goes on in it
};

// least, most: edges of the bundle along columns and rows.
BeamBlock beam_block(int2 origin_cell, real2 fraction, real2 least, real2 most, real depth, int level) {
    BeamBlock block;
    real size = real(1 << level);
    // The block whose middle is nearest to the bundle's.
    real2 at = real2(fraction.x + real(0.5) * depth * (least.x + most.x), fraction.y + real(0.5) * depth * (least.y + most.y));
    block.cell = int2((int(floor(at.x - real(0.5) * size)) + origin_cell.x) >> level,
                      (int(floor(at.y - real(0.5) * size)) + origin_cell.y) >> level);
    real2 low = real2(real((block.cell.x << level) - origin_cell.x) - fraction.x, real((block.cell.y << level) - origin_cell.y) - fraction.y);
    real2 high = real2(low.x + real(2) * size, low.y + real(2) * size);
    real leave_x = min(most.x > real(0) ? high.x / most.x : real(1e30), least.x < real(0) ? low.x / least.x : real(1e30));
    real leave_y = min(most.y > real(0) ? high.y / most.y : real(1e30), least.y < real(0) ? low.y / least.y : real(1e30));
    block.leave = min(leave_x, leave_y);
    block.fits = block.leave > depth && least.x * depth >= low.x && least.y * depth >= low.y && most.x * depth <= high.x &&
                 most.y * depth <= high.y;
    block.top = block_top(block.cell, level);
    return block;
}

// from: depth up to which it is known that no ray meets ground. flatness: the bundle may end in cells whose heights
// differ from their middle by at most this share of the middle's depth below the origin. It needs flat_ends, a
// constant, so that programs without flat ends do not pay for it.
Beam cast_beam(int2 origin_cell, real2 fraction, real3 middle, real3 spread, real from, real flatness) {
    Beam beam;
    beam.flat_end = false;
    beam.height_m = real(0);
    // Edges of the bundle: least and greatest speed along columns and rows, and its lowest and highest edge.
    real2 least = real2(middle.x - spread.x, middle.y - spread.y);
    real2 most = real2(middle.x + spread.x, middle.y + spread.y);
    real fall = middle.z - spread.z;
    real rise = middle.z + spread.z;
    // Before this depth no ray is over the terrain, or none is below its highest sample.
    real2 low_edge = real2(real(-origin_cell.x) - fraction.x, real(-origin_cell.y) - fraction.y);
    real2 high_edge = real2(real(patches.x - origin_cell.x) - fraction.x, real(patches.y - origin_cell.y) - fraction.y);
    real depth = from;
    if (low_edge.x > real(0)) depth = max(depth, beam_reach(low_edge.x, most.x));
    if (low_edge.y > real(0)) depth = max(depth, beam_reach(low_edge.y, most.y));
    if (high_edge.x < real(0)) depth = max(depth, beam_reach(-high_edge.x, -least.x));
    if (high_edge.y < real(0)) depth = max(depth, beam_reach(-high_edge.y, -least.y));
    real highest = load_highest();
    if (highest < real(0)) depth = max(depth, beam_reach(-highest, -fall));
    // And beyond this one all have left it.
    real end = min(min(least.x > real(0) ? high_edge.x / least.x : real(1e30), least.y > real(0) ? high_edge.y / least.y : real(1e30)),
                   min(most.x < real(0) ? low_edge.x / most.x : real(1e30), most.y < real(0) ? low_edge.y / most.y : real(1e30)));
    if (highest > real(0) && fall > real(0)) end = min(end, highest / fall);
    if (highest <= real(0) && fall >= real(0)) end = real(0);

    // What starts beyond the end has no cell there.
    depth = min(depth, max(end, real(0)));
    int level = top_level;
    int steps = 0;
    bool going = depth < end;
    do {
        BeamBlock block = beam_block(origin_cell, fraction, least, most, depth, level);
        real lowest = fall * (fall < real(0) ? max(block.leave, depth) : depth);
        bool free = block.fits && lowest > block.top;
        // Into the block: to where the lowest edge has come down to its top, then finer.
        real drop = block.fits && fall < real(0) && fall * depth > block.top ? max(depth, block.top / fall) : depth;
        // What is used behind the loop hangs on its value of the turn before (docs/devices.md).
        depth = !going ? depth : free ? block.leave : drop;
        level = !going ? level : free ? min(level + 1, top_level) : level - 1;
        going = going && depth < end && level >= 1 && block.fits && ++steps < beam_step_limit;
    } while (going);
    beam.depth = depth >= end ? max(end, depth) : depth;
    bool nothing = depth >= end;
    beam.level = nothing ? 0 : max(level, 1);
    if (flat_ends) {
        // Where the walk stopped: a block as long as the bundle's end is over ground. Does every ray come in by its top
        // and get below its lowest point before it leaves?
        real drawn_out = fall * depth * (real(1) / min(rise, real(-1e-6)) - real(1) / fall);
        real end_length = drawn_out * max(max(abs(least.x), abs(most.x)), max(abs(least.y), abs(most.y))) + depth * max(spread.x, spread.y);
        int last = min(beam.level + 1, top_level);
        for (int i = 0; i < 8; ++i) last += last < top_level && real(1 << last) < end_length ? 1 : 0;
        BeamBlock block = beam_block(origin_cell, fraction, least, most, depth, last);
        real bottom = block_bottom(block.cell, last);
        beam.height_m = real(0.5) * (block.top + bottom);
        beam.flat_end = flatness > real(0) && depth < end && block.fits && rise < real(0) && fall * depth >= block.top * real(1.00001) &&
                        bottom > block.leave * rise && block.top - beam.height_m <= -flatness * beam.height_m;
        beam.level = beam.flat_end ? last : beam.level;
    }
    return beam;
}

// What beams look at on a terrain in tiles: above the tiles' own size the tree's nodes, below it the pyramids of what is drawn
// there. whole_beam.glsl gives the same of a terrain that is held as a whole.
#include "render/tile_surface.glsl"
uniform int top_level;  // of a pyramid over the finest level: its cells are the coarsest tiles

// What is drawn where a node is: itself, or the tile that it lies in.
struct DrawnNode {
    real top;
    int slot;   // -1: several tiles below it
    int level;  // of the node that says so
};
DrawnNode drawn_node(int2 tile, int level) {
    real2 node = load_tile_node(tile, level);
    // What is used behind the loop hangs on its value of the turn before (docs/devices.md).
    do {
        bool up = node.y < real(-1.5) && level < tile_top_level;
        tile = up ? tile >> 1 : tile;
        level = up ? level + 1 : level;
        node = up ? load_tile_node(tile, level) : node;
    } while (node.y < real(-1.5) && level < tile_top_level);
    return DrawnNode(node.x, int(node.y), level);
}

// Highest ground of patches of the finest level that lie in one tile of it, from `first` to before `end`. level: of a
// pyramid whose blocks are as large.
real drawn_top(int2 tile, int2 first, int2 end, int level) {
    DrawnNode node = drawn_node(tile, 0);
    TilePlace place = load_tile(max(node.slot, 0));
    // Among the samples of what is drawn. Those of the finest level are counted; for others, more than rounding is added.
    real2 from = place.fraction + (real2(first - origin_cell) - origin_fraction) * place.scale;
    real2 to = place.fraction + (real2(end - origin_cell) - origin_fraction) * place.scale;
    real2 slack = real2(0.02, 0.02) + real(1e-6) * max(abs(from), abs(to));
    int2 low = place.origin_cell + (place.level == 0 ? first - origin_cell : int2(floor(from - slack)));
    int2 high = place.origin_cell + (place.level == 0 ? end - origin_cell : int2(ceil(to + slack))) - 1;
    low = clamp(low, int2(0, 0), room_patches - 1);
    high = clamp(high, int2(0, 0), room_patches - 1);
    int fine = clamp(level - place.level, 1, slot_top_level);
    // So coarse that 2 x 2 cells hold them.
    for (int k = 0; k < 2; ++k) fine += any(greaterThan((high >> fine) - (low >> fine), int2(1, 1))) ? 1 : 0;
    fine = min(fine, slot_top_level);
    int2 first_cell = low >> fine;
    int2 last_cell = high >> fine;
    real top = real(-1e30);
    for (int k = 0; k < 4; ++k) top = max(top, load_top(min(first_cell + int2(k & 1, k >> 1), last_cell), fine));
    return min(top, node.top);
}

// What rays are to know of where their beam stopped: the level of the tile that is drawn there, in 64ths.
float beam_note(real depth, real3 middle) {
    int2 cell = origin_cell + int2(floor(origin_fraction + depth * middle.xy));
    return float(drawn_node(clamp(cell, int2(0, 0), patches - 1) >> tile_side_level, 0).level) / 64.0;
}

// What maths/beam.glsl needs.
real block_top(int2 cell, int level) {
    int2 first = clamp(cell << level, int2(0, 0), patches);
    int2 end = clamp((cell + 2) << level, int2(0, 0), patches);
    real top = real(-1e30);
    if (all(lessThan(first, end))) {
        // Tiles of the level whose size is the cells', or of the finest.
        int tiles_level = max(level - tile_side_level, 0);
        int shift = tiles_level + tile_side_level;
        int2 tile = first >> shift;
        int2 more = ((end - 1) >> shift) - tile;
        int k = 0;
        do {
            int2 here = tile + int2(k & 1, k >> 1);
            int2 corner = here << shift;
            real found = level >= tile_side_level ? drawn_node(here, tiles_level).top
                                               : drawn_top(here, max(first, corner), min(end, corner + (1 << shift)), level);
            top = max(top, found);
            // On to the next one that there is.
            k += (k & 1) == 0 && more.x == 0 ? 2 : 1;
        } while (k < 2 + 2 * more.y);
    }
    return top;
}
real block_bottom(int2 cell, int level) { return real(-1e30); }

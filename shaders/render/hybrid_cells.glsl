// What becomes of a cell in method "hybrid". The including side has surface.glsl, camera.glsl and cell_box.glsl.
#include "render/hybrid_sectors.glsl"

uniform int cell_level;
uniform real pixel_m;           // width of a pixel at one metre
uniform real near_m;            // nearer along the view the mesh is cut off
uniform real pixels_per_patch;  // from so many on, the mesh is cheaper than rays
uniform real mesh_end_m;        // over ground; beyond it all cells are left to rays, and the reach ends there at the latest

const int cell_unseen = 0;
const int cell_mesh = 1;
const int cell_rays = 2;

bool has_patches(int2 cell) { return (cell.x << cell_level) < patches.x && (cell.y << cell_level) < patches.y; }

// True for the many cells that need no closer look.
bool beyond_mesh(int2 cell) {
    real2 low = (real2((cell << cell_level) - origin_cell) - origin_fraction) * cell_m;
    real2 high = (real2(((cell + 1) << cell_level) - origin_cell) - origin_fraction) * cell_m;
    return length(max(max(low, -high), real2(0.0))) >= mesh_end_m;
}

// Distances over ground from the eye to the nearest and to the farthest point of the cell.
real2 ground_span(CellBox box) {
    real2 nearest = max(max(box.low.xy, -box.high.xy), real2(0.0));
    real2 farthest = max(abs(box.low.xy), abs(box.high.xy));
    return real2(length(nearest), length(farthest));
}

// The upper hull of a patch, which hybrid_patch.vert draws, at a place in columns and rows from the origin cell; far below
// beside the terrain.
real hull_height(real2 place) {
    int2 at = origin_cell + int2(floor(place));
    if (any(lessThan(at, int2(0))) || any(greaterThanEqual(at, patches))) return -1e30;
    real4 z = load_corners(at);
    real2 w = place - real2(at - origin_cell);
    real falling = w.x >= w.y ? z.x + w.x * (z.y - z.x) + w.y * (z.w - z.y) : z.x + w.y * (z.z - z.x) + w.x * (z.w - z.z);
    real rising = w.x + w.y <= 1.0 ? z.x + w.x * (z.y - z.x) + w.y * (z.z - z.x)
                                   : z.w + (1.0 - w.x) * (z.z - z.w) + (1.0 - w.y) * (z.y - z.w);
    return max(falling, rising);
}

// True where the eye is below the mesh, or so near to it that the near plane would cut it.
bool eye_is_low() {
    real margin = 20.0 * near_m;
    for (int i = 0; i < 5; ++i) {
        real2 off = i == 4 ? real2(0.0) : margin * cells_per_m * real2((i & 1) == 0 ? -1.0 : 1.0, (i & 2) == 0 ? -1.0 : 1.0);
        if (hull_height(origin_fraction + off) >= -margin) return true;
    }
    return false;
}

// True where rays alone tell: the eye is low in the cell, or sees the terrain's side through it.
bool needs_rays(int2 cell, CellBox box) {
    int2 first = cell << cell_level;
    int2 last = (cell + 1) << cell_level;
    if (first.x == 0 && box.low.x > 0.0 || last.x >= patches.x && box.high.x < 0.0) return true;
    if (last.y >= patches.y && box.low.y > 0.0 || first.y == 0 && box.high.y < 0.0) return true;
    if (origin_cell.x < first.x || origin_cell.x >= last.x || origin_cell.y < first.y || origin_cell.y >= last.y) return false;
    return eye_is_low();
}

// The pixels that a patch of the cell covers: its area as the eye sees it, with its relief.
real pixels_of_patch(CellBox box) {
    real3 middle = 0.5 * (box.low + box.high);
    real3 nearest = real3(max(max(box.low, -box.high), real3(0.0)));
    real distance = max(0.5 * (length(middle) + length(nearest)), 0.25 * min(cell_m.x, cell_m.y));
    real3 way = abs(middle) / max(length(middle), 1e-6);
    real relief = 0.5 * (box.high.z - box.low.z) / max(box.high.x - box.low.x, box.high.y - box.low.y);
    real facing = way.z + relief * length(way.xy);
    return cell_m.x * cell_m.y * facing / (distance * distance * pixel_m * pixel_m);
}

// The pixels in the picture of the rectangle around a box.
real pixels_around(CellBox box) {
    real2 low = real2(1.0);
    real2 high = real2(-1.0);
    for (int i = 0; i < 8; ++i) {
        real3 clip = clip_of(box_corner(box, i));
        bool before = clip.z > 0.0;
        real2 at = before ? clamp(clip.xy / max(clip.z, 1e-6), -1.0, 1.0) : real2(0.0);
        low = before ? min(low, at) : real2(-1.0);
        high = before ? max(high, at) : real2(1.0);
    }
    real2 size = 0.5 * max(high - low, 0.0) * picture_size;
    return size.x * size.y;
}

// Pixels that a cell's mesh draws, less those that would cost as much as its patches.
real gain_of_mesh(CellBox box) {
    real patch_count = real(1 << (2 * cell_level));
    return min(patch_count * pixels_of_patch(box), pixels_around(box)) - patch_count * pixels_per_patch;
}

// The cheaper way for a cell.
int cell_choice(int2 cell, CellBox box) {
    if (needs_rays(cell, box)) return cell_rays;
    if (!box_in_view(box)) return cell_unseen;
    return pixels_of_patch(box) >= pixels_per_patch ? cell_mesh : cell_rays;
}

// What becomes of a cell in method "hybrid". The including side has surface.glsl, camera.glsl and cell_box.glsl.
#include "maths/patch.glsl"
#include "render/hybrid_sectors.glsl"

uniform int cell_level;
uniform real pixel_m;           // width of a pixel at one metre
uniform real pixels_per_patch;  // from so many on, the mesh is cheaper than rays

const int cell_unseen = 0;
const int cell_mesh = 1;
const int cell_rays = 2;

bool has_patches(int2 cell) { return (cell.x << cell_level) < patches.x && (cell.y << cell_level) < patches.y; }

// Distances over ground from the eye to the nearest and to the farthest point of the cell.
real2 ground_span(CellBox box) {
    real2 nearest = max(max(box.low.xy, -box.high.xy), real2(0.0));
    real2 farthest = max(abs(box.low.xy), abs(box.high.xy));
    return real2(length(nearest), length(farthest));
}

// True where rays alone tell: the eye is below the ground, or sees the terrain's side through the cell.
bool needs_rays(int2 cell, CellBox box) {
    int2 first = cell << cell_level;
    int2 last = (cell + 1) << cell_level;
    if (first.x == 0 && box.low.x > 0.0 || last.x >= patches.x && box.high.x < 0.0) return true;
    if (last.y >= patches.y && box.low.y > 0.0 || first.y == 0 && box.high.y < 0.0) return true;
    if (origin_cell.x < first.x || origin_cell.x >= last.x || origin_cell.y < first.y || origin_cell.y >= last.y) return false;
    if (origin_cell.x >= patches.x || origin_cell.y >= patches.y) return false;
    return patch_height(load_corners(origin_cell), origin_fraction) >= 0.0;
}

// The pixels that a patch of the cell covers: its area as the eye sees it, with its relief.
real pixels_of_patch(CellBox box) {
    real3 middle = 0.5 * (box.low + box.high);
    real3 nearest = real3(max(max(box.low, -box.high), real3(0.0)));
    real distance = max(0.5 * (length(middle) + length(nearest)), 0.25 * cell_m.x);
    real3 way = abs(middle) / max(length(middle), 1e-6);
    real relief = 0.5 * (box.high.z - box.low.z) / max(box.high.x - box.low.x, box.high.y - box.low.y);
    real facing = way.z + relief * length(way.xy);
    return cell_m.x * cell_m.y * facing / (distance * distance * pixel_m * pixel_m);
}

// The cheaper way for a cell.
int cell_choice(int2 cell, CellBox box) {
    if (needs_rays(cell, box)) return cell_rays;
    if (!box_in_view(box)) return cell_unseen;
    return pixels_of_patch(box) >= pixels_per_patch ? cell_mesh : cell_rays;
}

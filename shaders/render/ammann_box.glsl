// A cell's box, and how it is drawn. The including side has surface.glsl, camera.glsl, cell_grid.glsl and cell_box.glsl.

uniform sampler2D cell_bounds;

CellBox ammann_box(int2 cell) {
    int2 first = cell * cell_patches;
    int2 last = min(first + cell_patches, patches);
    real2 bounds_m = (texelFetch(cell_bounds, cell, 0).rg - origin_height_m.x) - origin_height_m.y;
    return box_over(first, last, bounds_m);
}

// What the cells are drawn by: the mesh, then the levels of precision of its rays from the highest on.
const uint by_mesh = 0u;
const uint by_rays = 1u;
const uint not_drawn = 255u;

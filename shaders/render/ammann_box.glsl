// A cell's box. The including side has surface.glsl, camera.glsl, cell_grid.glsl and cell_box.glsl.

uniform sampler2D cell_bounds;

CellBox ammann_box(int2 cell) {
    int2 first = cell * cell_patches;
    int2 last = min(first + cell_patches, patches);
    real2 bounds_m = (texelFetch(cell_bounds, cell, 0).rg - origin_height_m.x) - origin_height_m.y;
    return box_over(first, last, bounds_m);
}

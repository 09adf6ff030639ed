// A sample of a cell's mesh: (cell_patches + 1)^2 vertices, row by row; those beyond the terrain lie on its edge.
#include "render/surface.glsl"
#include "render/camera.glsl"

layout(std430) readonly buffer MeshCells { uint draw_arguments[8]; uint mesh_cells[]; };

uniform int cell_patches;
uniform int cell_columns;
uniform real near_m;

void main() {
    int cell = int(mesh_cells[gl_InstanceID]);
    int side = cell_patches + 1;
    int2 at = int2(cell % cell_columns, cell / cell_columns) * cell_patches + int2(gl_VertexID % side, gl_VertexID / side);
    at = min(at, patches);
    real2 place = (real2(at - origin_cell) - origin_fraction) * cell_m;
    real height = (texelFetch(ground, at, 0).r - origin_height_m.x) - origin_height_m.y;
    real3 clip = clip_of(real3(place.x, -place.y, height));
    gl_Position = vec4(clip.xy, near_m, clip.z);
}

// A vertex of the two triangles over a patch of a listed cell, six a patch. They join along the higher diagonal, so they
// are the upper hull of the bilinear patch and touch it on all four edges.
#include "render/surface.glsl"
#include "render/camera.glsl"
#include "render/hybrid_list.glsl"

uniform int cell_level;
uniform int second_half;  // 1: of the list
uniform real near_m;

flat out vec4 corners;  // over the eye
flat out ivec2 offset;  // the patch, from the eye's

void main() {
    int columns = level_1_size.x >> (cell_level - 1);
    int cell = int(mesh_cells[second_half * cell_capacity() + gl_InstanceID]);
    int index = gl_VertexID / 6;
    int side = 1 << cell_level;
    int2 at = (int2(cell % columns, cell / columns) << cell_level) + int2(index & (side - 1), index >> cell_level);
    bool outside = at.x >= patches.x || at.y >= patches.y;
    at = min(at, patches - 1);
    corners = load_corners(at);
    offset = at - origin_cell;
    // Corners as bits, column first; counter-clockwise from above.
    int k = gl_VertexID % 6;
    bool falling = corners.x + corners.w >= corners.y + corners.z;
    int corner = ((falling ? 0x738 : 0xe58) >> (2 * k)) & 3;
    if (outside) corner = 0;
    real2 place = (real2(offset + int2(corner & 1, corner >> 1)) - origin_fraction) * cell_m;
    real height = corner == 0 ? corners.x : corner == 1 ? corners.y : corner == 2 ? corners.z : corners.w;
    real3 clip = clip_of(real3(place.x, -place.y, height));
    gl_Position = vec4(clip.xy, near_m, clip.z);
}

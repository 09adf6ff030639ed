// A vertex of the two triangles over a patch of the outer mesh, six a patch of a listed cell. They join along the higher diagonal,
// so that they lie over the bilinear patch.
#include "render/surface.glsl"
#include "render/camera.glsl"

layout(std430) readonly buffer MeshCells { uint draw_arguments[8]; uint mesh_cells[]; };
uniform sampler2D envelope;

uniform int cell_level;
uniform real near_m;

flat out ivec2 drawn_patch;

// Corners as bits, column 1, row 2; counter-clockwise from above. The diagonal from north-west to south-east, or the other.
const int falling_corners[6] = int[](0, 2, 3, 0, 3, 1);
const int rising_corners[6] = int[](0, 2, 1, 1, 2, 3);

void main() {
    int columns = level_1_size.x >> (cell_level - 1);
    int cell = int(mesh_cells[gl_InstanceID]);
    int index = gl_VertexID / 6;
    int2 at = (int2(cell % columns, cell / columns) << cell_level) + int2(index & ((1 << cell_level) - 1), index >> cell_level);
    bool outside = at.x >= patches.x || at.y >= patches.y;
    at = min(at, patches - 1);
    drawn_patch = at;
    real4 corners = (textureGather(envelope, vec2(at + 1) / vec2(patches + 1)).wzxy - origin_height_m.x) - origin_height_m.y;
    bool falling = corners.x + corners.w >= corners.y + corners.z;
    int k = gl_VertexID % 6;
    int corner = outside ? 0 : falling ? falling_corners[k] : rising_corners[k];
    real2 place = (real2(at - origin_cell + int2(corner & 1, corner >> 1)) - origin_fraction) * cell_m;
    real3 clip = clip_of(real3(place.x, -place.y, corners[corner]));
    gl_Position = vec4(clip.xy, near_m, clip.z);
}

// The box of a listed cell, six vertices a face; from inside they wind clockwise and are not drawn. Below it is ground, which
// nobody sees from: it has no face there.
#include "render/surface.glsl"
#include "render/camera.glsl"
#include "render/cell_grid.glsl"
#include "render/cell_box.glsl"
#include "render/ammann_box.glsl"

layout(std430) readonly buffer RayCells { uint ray_arguments[]; };

uniform int first_cell;  // of the level's, in the list
uniform real near_m;

flat out ivec2 drawn_cell;

// Corners as bits: east 1, north 2, up 4. Counter-clockwise from outside: east, west, north, south, top.
const int faces[20] = int[](1, 3, 7, 5, 2, 0, 4, 6, 3, 2, 6, 7, 0, 1, 5, 4, 4, 5, 7, 6);
const int triangles[6] = int[](0, 1, 2, 0, 2, 3);

void main() {
    drawn_cell = cell_at(int(ray_arguments[first_cell + gl_InstanceID]));
    int corner = faces[4 * (gl_VertexID / 6) + triangles[gl_VertexID % 6]];
    real3 clip = clip_of(box_corner(ammann_box(drawn_cell), corner));
    gl_Position = vec4(clip.xy, near_m, clip.z);
}

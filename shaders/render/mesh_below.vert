// Covers the picture where the eye is below the ground, with a triangle nearer than all others; nothing elsewhere.
#include "render/surface.glsl"
#include "maths/patch.glsl"

void main() {
    bool over_terrain = all(greaterThanEqual(origin_cell, int2(0))) && all(lessThan(origin_cell, patches));
    int2 patch_at = clamp(origin_cell, int2(0), patches - 1);
    bool below = over_terrain && patch_height(load_corners(patch_at), origin_fraction) >= 0.0;
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    gl_Position = below ? vec4(corner, 1.0, 1.0) : vec4(0.0);
}

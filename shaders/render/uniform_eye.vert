// Covers the picture where the eye is over the terrain and not above all of it; nothing elsewhere.
#include "render/surface.glsl"

void main() {
    bool over_terrain = all(greaterThanEqual(origin_cell, int2(0))) && all(lessThan(origin_cell, patches));
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    gl_Position = over_terrain && load_highest() >= 0.0 ? vec4(corner, 1.0, 1.0) : vec4(0.0);
}

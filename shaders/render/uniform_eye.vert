// Covers the picture where the eye is over the terrain and not above its block: there the envelope is no higher than the block's
// highest sample. Nothing elsewhere.
#include "render/surface.glsl"
#include "render/envelope.glsl"

void main() {
    bool over_terrain = all(greaterThanEqual(origin_cell, int2(0))) && all(lessThan(origin_cell, patches));
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    int2 cell = min(max(origin_cell, int2(0)), patches - 1) >> envelope_level;
    real top_m = top_level >= envelope_level ? load_top(cell, envelope_level) : load_highest();
    gl_Position = over_terrain && top_m >= 0.0 ? vec4(corner, 1.0, 1.0) : vec4(0.0);
}

// The surface as shaders of render read it: ground samples and the max pyramid over the patches between them.
#include "render/pyramid_layout.glsl"

uniform sampler2D ground;
uniform sampler2D tops;

uniform int2 patches;
uniform int top_level;
uniform real2 cell_m;
uniform int2 origin_cell;       // the eye's patch (column, row), and where in it
uniform real2 origin_fraction;
uniform real2 origin_height_m;  // the eye's height, two words

real load_top(int2 cell, int level) {
    return (texelFetch(tops, pyramid_texel(cell, level), 0).r - origin_height_m.x) - origin_height_m.y;
}

real load_highest() { return (texelFetch(tops, whole_texel(), 0).r - origin_height_m.x) - origin_height_m.y; }

real4 load_corners(int2 at) {
    real4 z = textureGather(ground, vec2(at + 1) / vec2(patches + 1)).wzxy;
#ifdef COLUMNS
    // A patch as a column: flat at the height of its middle, with walls down to lower neighbours.
    z = real4(0.25 * (z.x + z.y + z.z + z.w));
#endif
    return (z - origin_height_m.x) - origin_height_m.y;
}

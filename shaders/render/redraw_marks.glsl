// Blocks of the picture that must be drawn again.
#include "render/block_pixels.glsl"

layout(std430) buffer RedrawMarks {
    uint lowest_before;    // bits of the terrain's bounds before the change
    uint highest_before;
    uint redraw_all;       // not 0: every block
    uint unused;
    uint redraw_marks[];
};

uniform int2 blocks;  // in a row, in a column

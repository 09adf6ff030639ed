// All levels of the pyramid lie in one image: level 1 on top, the coarser ones side by side below it. One level of
// detail fetches faster than mip levels chosen per lane (docs/benchmarks.md).
#include "maths/glsl_types.glsl"

uniform int2 level_1_size;

int2 pyramid_texel(int2 cell, int level) {
    return int2(cell.x + max(level_1_size.x - ((2 * level_1_size.x) >> (level - 1)), 0),
                cell.y + (level > 1 ? level_1_size.y : 0));
}

// The bounds of the whole terrain have the image's last texel, which no level reaches.
int2 whole_texel() { return int2(level_1_size.x, level_1_size.y + max(level_1_size.y / 2, 1)) - 1; }

// The last column or row of samples may start a tile that has no patches, so no cells.
bool has_cell(int2 cell, int level) {
    int2 size = level_1_size >> (level - 1);
    return cell.x < size.x && cell.y < size.y;
}

// A vertex of a listed block's triangles. Those of the raised mesh, two a patch, join along the higher diagonal, so that they lie
// over the bilinear patch; with SIMPLIFIED a word tells three samples.
#include "render/surface.glsl"
#include "render/camera.glsl"
#include "render/uniform_block_at.glsl"

layout(std430) readonly buffer UniformBlocks { uint draw_arguments[4 * block_kinds]; uint listed_blocks[]; };
uniform sampler2D envelope;

uniform int kind;
uniform real near_m;

flat out ivec2 drawn_patch;

#ifdef SIMPLIFIED
layout(std430) readonly buffer SimplifiedBlocks { uint triangle_words[]; };

int2 vertex_of(int2 block, int number) {
    uint word = triangle_words[words_of_block(block) + number / 3];
    int vertex = int(word >> (7 * (number % 3))) & 127;
    return (block << envelope_level) + int2(vertex % (envelope_patches + 1), vertex / (envelope_patches + 1));
}
#else
// Corners as bits, column 1, row 2; counter-clockwise from above. The diagonal from north-west to south-east, or the other.
const int falling_corners[6] = int[](0, 2, 3, 0, 3, 1);
const int rising_corners[6] = int[](0, 2, 1, 1, 2, 3);

real height_at(int2 at) { return (texelFetch(envelope, at, 0).r - origin_height_m.x) - origin_height_m.y; }

int2 vertex_of(int2 block, int number) {
    int index = number / 6;
    int2 at = (block << envelope_level) + int2(index & (envelope_patches - 1), index >> envelope_level);
    // Beyond the terrain all corners are one.
    if (at.x >= patches.x || at.y >= patches.y) return block << envelope_level;
    bool falling = height_at(at) + height_at(at + 1) >= height_at(at + int2(1, 0)) + height_at(at + int2(0, 1));
    int corner = falling ? falling_corners[number % 6] : rising_corners[number % 6];
    return at + int2(corner & 1, corner >> 1);
}
#endif

void main() {
    int vertices = 3 * kind_triangles[kind];
    int number = int(listed_blocks[kind * blocks.x * blocks.y + gl_VertexID / vertices]);
    int2 block = int2(number % blocks.x, number / blocks.x);
    drawn_patch = block << envelope_level;
    int2 at = vertex_of(block, gl_VertexID % vertices);
    real2 place = (real2(at - origin_cell) - origin_fraction) * cell_m;
    real height_m = (texelFetch(envelope, at, 0).r - origin_height_m.x) - origin_height_m.y;
    real3 clip = clip_of(real3(place.x, -place.y, height_m));
    gl_Position = vec4(clip.xy, near_m, clip.z);
}

// Marks the blocks of the picture that a listed tile may touch: its own ground, the ground around it whose filtered
// normals look at it, and its shadow.
layout(local_size_x = 1) in;
#include "sim/tile_samples.glsl"
#include "render/surface.glsl"
#include "render/camera.glsl"
#include "render/cell_box.glsl"
#include "render/redraw_marks.glsl"

layout(std430) readonly buffer TileList { uint list_arguments[4]; uint listed_tiles[]; };

uniform int2 tiles;
uniform int after;   // 0 before the pyramid is rebuilt, 1 after
uniform real3 sun;  // towards it; 0: nothing casts shadows

uniform int shading_reach;  // samples; at most a tile

void main() {
    int tile = int(listed_tiles[gl_WorkGroupID.y]);
    int2 at = int2(tile % tiles.x, tile / tiles.x);
    uint lowest_bits = floatBitsToUint(texelFetch(bottoms, whole_texel(), 0).r);
    uint highest_bits = floatBitsToUint(texelFetch(tops, whole_texel(), 0).r);
    // All tiles write the same here. Colours go by the share of the terrain's relief.
    if (after == 0) {
        lowest_before = lowest_bits;
        highest_before = highest_bits;
    } else if (lowest_before != lowest_bits || highest_before != highest_bits) {
        redraw_all = 1u;
    }

    // The tile's box with its neighbours' heights, as far as shading looks.
    int level = min(tile_level, top_level);
    int2 first = max((at - 1) << (tile_level - level), int2(0));
    int2 last = min(((at + 2) << (tile_level - level)) - 1, (level_1_size >> (level - 1)) - 1);
    CellBox box;
    box.low.z = uintBitsToFloat(0x7f800000u);
    box.high.z = uintBitsToFloat(0xff800000u);
    for (int y = first.y; y <= last.y; ++y)
        for (int x = first.x; x <= last.x; ++x) {
            CellBox cell = cell_box(int2(x, y), level);
            box.low.z = min(box.low.z, cell.low.z);
            box.high.z = max(box.high.z, cell.high.z);
        }
    if (!(box.low.z <= box.high.z)) return;
    real2 west_north = (real2(max(at * tile_samples - shading_reach, int2(0)) - origin_cell) - origin_fraction) * cell_m;
    real2 east_south = (real2(min((at + 1) * tile_samples + shading_reach, patches) - origin_cell) - origin_fraction) * cell_m;
    box.low.xy = real2(west_north.x, -east_south.y);
    box.high.xy = real2(east_south.x, -west_north.y);
    // The side of the terrain is cut down to below everything.
    real floor_m = uintBitsToFloat(lowest_bits) - origin_height_m.x - 1.0;
    if (at.x == 0 || at.y == 0 || (at.x + 1) * tile_samples >= patches.x || (at.y + 1) * tile_samples >= patches.y) box.low.z = min(box.low.z, floor_m);

    // Away from the sun down to the lowest ground.
    real3 shadow = real3(0.0);
    if (sun.z > 0.0) shadow = real3(-sun.xy / sun.z, -1.0) * max(box.high.z - floor_m, 0.0);
    real2 low = real2(1e30);
    real2 high = real2(-1e30);
    bool before_the_eye = true;
    int outside = 31;  // of the view's planes, with a hundredth of the picture more
    for (int i = 0; i < 16; ++i) {
        real3 corner = box_corner(box, i & 7) + (i < 8 ? real3(0.0) : shadow);
        real3 clip = clip_of(corner);
        before_the_eye = before_the_eye && clip.z > 1e-3 * cell_m.x;
        outside &= (clip.x > 1.01 * clip.z ? 1 : 0) | (clip.x < -1.01 * clip.z ? 2 : 0) | (clip.y > 1.01 * clip.z ? 4 : 0) |
                   (clip.y < -1.01 * clip.z ? 8 : 0) | (clip.z < 0.0 ? 16 : 0);
        low = min(low, clip.xy / clip.z);
        high = max(high, clip.xy / clip.z);
    }
    if (outside != 0) return;
    if (!before_the_eye) {
        low = real2(-1.0);
        high = real2(1.0);
    }
    // A pixel more on either side.
    int2 from = max(int2(floor((0.5 + 0.5 * clamp(low, -2.0, 2.0)) * picture_size - 1.0)) / block_pixels, int2(0));
    int2 to = min(int2(floor((0.5 + 0.5 * clamp(high, -2.0, 2.0)) * picture_size + 1.0)) / block_pixels, blocks - 1);
    for (int y = from.y; y <= to.y; ++y)
        for (int x = from.x; x <= to.x; ++x) redraw_marks[y * blocks.x + x] = 1u;
}

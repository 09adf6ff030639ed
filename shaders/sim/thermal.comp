// One sub-step of thermal erosion on the listed tiles: a group for each block of a tile.
layout(local_size_x = 16, local_size_y = 16) in;
#include "sim/tile_samples.glsl"
#include "sim/samples.glsl"

layout(std430) readonly buffer TileList { uint list_arguments[4]; uint listed_tiles[]; };

layout(std140) uniform ThermalNumbers {
#include "maths/thermal_numbers.glsl"
};

#ifdef WET
#include "sim/water_layout.glsl"
layout(rgba32f) uniform readonly image2D water;  // with two ghost samples around
real load_repose(int2 at) { return imageLoad(water, at + water_ghosts).x >= wet_depth_m ? wet_slope : repose_slope; }
#else
real load_repose(int2 at) { return repose_slope; }
#endif
#ifdef MASKED
layout(rgba32f) uniform readonly image2D painted;
real load_mask(int2 at) { return imageLoad(painted, clamp(at, int2(0), samples - 1)).y; }
#else
real load_mask(int2 at) { return real(1); }
#endif
#include "maths/thermal.glsl"
#ifdef WEAR_MAP
#include "maths/wear.glsl"
layout(rgba32f) uniform image2D worn;
#endif
#ifdef OLSEN
bool is_sample(int2 at) { return at.x >= 0 && at.y >= 0 && at.x < samples.x && at.y < samples.y; }
const bool only_lowest = OLSEN == 2;
#include "maths/olsen.glsl"
#endif

void main() {
    int tile = int(listed_tiles[gl_WorkGroupID.y]);
    int block = int(gl_WorkGroupID.x);
    const int blocks_across = tile_samples / block_samples;
    int2 at = int2(tile % tiles.x, tile / tiles.x) * tile_samples + int2(block % blocks_across, block / blocks_across) * block_samples + int2(gl_LocalInvocationID.xy);
    if (at.x >= samples.x || at.y >= samples.y) return;
    real4 before = load_solid(at);
#ifdef OLSEN
    real4 after = olsen_sample(at);
#else
    real4 after = thermal_sample(at);
#endif
    imageStore(solid_out, at, after);
    if (floatBitsToUint(after.x) != floatBitsToUint(before.x) || floatBitsToUint(after.y) != floatBitsToUint(before.y) ||
        floatBitsToUint(after.z) != floatBitsToUint(before.z) || floatBitsToUint(after.w) != floatBitsToUint(before.w)) {
        imageStore(ground_out, at, vec4(ground_height(after)));
#ifdef WEAR_MAP
        imageStore(worn, at, wear_counted(imageLoad(worn, at), before, after));
#endif
        mark_tile(at);
    }
}

// For tiles whose ground or water others changed: copies the ground to the water's bed and the front images of water and
// load to the back ones, finds the tile's fastest wave anew, and wakes its water. A group per listed tile.
layout(local_size_x = 64) in;
#include "sim/tile_samples.glsl"
#include "sim/water_images.glsl"

layout(rgba32f) uniform readonly image2D water_in;
layout(rgba32f) uniform writeonly image2D water_out;
layout(r32f) uniform writeonly image2D bed_out;
layout(r32f) uniform readonly image2D ground_in;
#ifdef SEDIMENT
layout(rg32f) uniform readonly image2D load_in;
layout(rg32f) uniform writeonly image2D load_out;
#endif
layout(std430) buffer WaterActivity { uint water_activity[]; };
#include "sim/water_activity.glsl"
layout(std430) readonly buffer TileList { uint list_arguments[4]; uint listed_tiles[]; };
layout(std430) buffer TileSpeeds { uint tile_speeds[]; };

const int water_order = 1;
const real2 water_share = real2(0.0);
const real water_drain = real(0);
const real water_friction = real(0);
#include "sim/cube_root_seed.glsl"
#include "maths/water.glsl"

shared uint fastest;

void main() {
    int tile = int(listed_tiles[gl_WorkGroupID.y]);
    int2 first = int2(tile % tiles.x, tile / tiles.x) * tile_samples + int2(int(gl_LocalInvocationIndex), 0);
    if (gl_LocalInvocationIndex == 0u) fastest = 0u;
    barrier();
    real mine = real(0);
    if (first.x < samples.x) {
        for (int row = 0; row < min(tile_samples, samples.y - first.y); ++row) {
            int2 at = first + int2(0, row);
            real4 water = imageLoad(water_in, at + water_ghosts);
            imageStore(water_out, at + water_ghosts, water);
            imageStore(bed_out, at + water_ghosts, imageLoad(ground_in, at));
#ifdef SEDIMENT
            imageStore(load_out, at + water_ghosts, imageLoad(load_in, at + water_ghosts));
#endif
            mine = max(mine, water_speed(water));
        }
    }
    atomicMax(fastest, floatBitsToUint(mine));
    barrier();
    if (gl_LocalInvocationIndex == 0u) {
        tile_speeds[tile] = fastest;
        water_activity[tile] = wet_all;
    }
}

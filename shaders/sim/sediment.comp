// After a sub-step: the water's load and the bed exchange solid, on the listed tiles, a group for each strip of a tile. Of its
// neighbours a sample looks at the bed alone, so that all else is in place.
layout(local_size_x = 64) in;
#include "sim/tile_samples.glsl"
#include "sim/water_images.glsl"

layout(rgba32f) uniform readonly image2D water_in;
layout(rg32f) uniform image2D load;
layout(r32f) uniform readonly image2D bed;  // the ground before, which sediment_bed.comp brings up to it
#ifdef PAINTED
layout(rgba32f) uniform readonly image2D painted;
#endif
#ifdef LAND_COVER
layout(rgba32f) uniform readonly image2D land_cover;
#endif
layout(rgba32f) uniform image2D solid;
#ifdef WEAR_MAP
layout(rgba32f) uniform image2D worn;
#endif
layout(r32f) uniform writeonly image2D ground;
#include "sim/tile_stamps.glsl"
layout(std430) buffer WaterActivity { uint water_activity[]; };
#include "sim/water_activity.glsl"
layout(std430) readonly buffer TileList { uint list_arguments[4]; uint listed_tiles[]; };

layout(std140) uniform SedimentNumbers {
#include "maths/sediment_numbers.glsl"
};

const int water_order = 1;
const real2 water_share = real2(0.0);
const real water_drain = real(0);
const real water_friction = real(0);
precise real sediment_dt = clock_dt_s * real(water_eulers);
#include "sim/cube_root_seed.glsl"
#include "maths/water.glsl"
#include "maths/ground_height.glsl"
#ifdef LAND_COVER
#include "maths/land_cover.glsl"
#endif
#include "maths/sediment_exchange.glsl"
#ifdef WEAR_MAP
#include "maths/rise.glsl"
#include "maths/wear.glsl"
#endif

bool differs(real4 a, real4 b) {
    return any(notEqual(floatBitsToUint(a), floatBitsToUint(b)));
}

bool is_edge(int2 at) {
    return at.x == 0 || at.y == 0 || at.x == samples.x - 1 || at.y == samples.y - 1;
}

// Of the water on its bed.
real drag_at(int2 at) {
#ifdef LAND_COVER
    real4 cover = imageLoad(land_cover, at);
    return cover.y == real(0) ? sediment_drag : sediment_drag_of(land_cover_roughness(cover));
#else
    return sediment_drag;
#endif
}

real bed_at(int2 at) { return imageLoad(bed, at + water_ghosts).x; }

void main() {
    int tile = int(listed_tiles[gl_WorkGroupID.y]);
    int column = int(gl_LocalInvocationIndex);
    int first_row = int(gl_WorkGroupID.x) * strip_rows;
    int2 first = int2(tile % tiles.x, tile / tiles.x) * tile_samples + int2(column, first_row);
    if (first.x >= samples.x) return;
    uint awake = 0u;  // what exchanges keeps the water awake
    bool loads = false;
    bool erodes = false;
    real here = bed_at(first);
    real north = bed_at(first + int2(0, -1));
    for (int row = 0; row < min(strip_rows, samples.y - first.y); ++row) {
        int2 at = first + int2(0, row);
        real south = bed_at(at + int2(0, 1));
        real before_here = here;
        real west = bed_at(at + int2(-1, 0));
        real east = bed_at(at + int2(1, 0));
        real lowest = min(min(west, east), min(north, south));
        real highest = max(max(west, east), max(north, south));
        precise real drop = here - lowest;
        precise real rise = highest - here;
        north = here;
        here = south;
        real4 water = imageLoad(water_in, at + water_ghosts);
        real shear = sediment_shear(water, drag_at(at));
        SedimentSample before;
        before.load = imageLoad(load, at + water_ghosts).xy;
        // Where nothing is carried and nothing taken, nothing changes.
        if (before.load == real2(0.0) && shear <= sediment_critical) continue;
        before.solid = imageLoad(solid, at);
#ifdef PAINTED
        real hardness = sediment_hardness(imageLoad(painted, at));
#else
        real hardness = real(0);
#endif
        SedimentSample after = sediment_exchange(water, shear, before, hardness, is_edge(at), drop, rise);
        bool carries = any(notEqual(floatBitsToUint(after.load), floatBitsToUint(before.load)));
        if (carries) imageStore(load, at + water_ghosts, real4(after.load.x, after.load.y, 0.0, 0.0));
        if (carries) awake |= wet;
        loads = loads || carries;
        if (!differs(after.solid, before.solid)) continue;
        imageStore(solid, at, after.solid);
#ifdef WEAR_MAP
        imageStore(worn, at, wear_counted(imageLoad(worn, at), before.solid, after.solid));
#endif
        awake |= wet;
        erodes = true;
        real height = ground_height(after.solid);
        if (height == before_here) continue;
        imageStore(ground, at, real4(height));
        awake |= first_row + row < water_reach ? wet_north : 0u;
        awake |= first_row + row >= tile_samples - water_reach ? wet_south : 0u;
        awake |= column < water_reach ? wet_west : 0u;
        awake |= column >= tile_samples - water_reach ? wet_east : 0u;
    }
    if (awake != 0u && (water_activity[tile] & awake) != awake) atomicOr(water_activity[tile], awake);
    if (loads) stamp_tile(tile, tile_load);
    if (erodes) stamp_tile(tile, tile_eroded);
}

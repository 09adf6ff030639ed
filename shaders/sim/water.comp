// One stage of a sub-step of shallow water on the listed tiles: a group for each strip of a tile. An invocation marches
// southwards down its column, so that each face between rows is solved once. ORDER 1: an Euler step in each
// STAGE. ORDER 2: STAGE 1
// writes the Euler step to `back`; STAGE 2 reads it there and completes `front` in place (each texel by its owner).
layout(local_size_x = 64) in;
#include "sim/tile_samples.glsl"
#include "sim/water_images.glsl"

layout(rgba32f) uniform readonly image2D water_in;
#if ORDER == 2 && STAGE == 2
layout(rgba32f) uniform image2D water_out;
#else
layout(rgba32f) uniform writeonly image2D water_out;
#endif
layout(r32f) uniform readonly image2D bed_in;
#include "sim/tile_stamps.glsl"
layout(std430) buffer WaterActivity { uint water_activity[]; };
#include "sim/water_activity.glsl"
layout(std430) readonly buffer TileList { uint list_arguments[4]; uint listed_tiles[]; };
layout(std430) buffer TileSpeeds { uint tile_speeds[]; };
#ifdef SEDIMENT
layout(rg32f) uniform readonly image2D load_in;
#if ORDER == 2 && STAGE == 2
layout(rg32f) uniform image2D load_out;
#else
layout(rg32f) uniform writeonly image2D load_out;
#endif
#endif
#ifdef SOURCES
layout(std430) buffer TileSources { dvec2 tile_sources[]; };  // metres of loss and of rain by the map, per tile and strip
shared dvec2 column_sources[tile_samples];
#ifdef RAIN_MAP
layout(rgba32f) uniform readonly image2D painted;
#endif
#endif

const int water_order = ORDER;
real2 water_share = real2(clock_share_x, clock_share_y);
real water_drain = clock_drain;
#ifdef FRICTION
real water_friction = clock_friction;
#else
const real water_friction = real(0);
#endif
#include "sim/cube_root_seed.glsl"
#include "maths/water.glsl"
#include "maths/water_stage.glsl"
#include "maths/water_sources.glsl"
#ifdef SEDIMENT
#include "maths/sediment_transport.glsl"

// A sample's load, and by the way its concentration.
real load_concentration(int2 at, real depth) { return sediment_concentration(depth, imageLoad(load_in, at + water_ghosts).x); }
#endif

// A sample seen along y: `along` is north.
WaterCell load_cell(int2 at, out real4 water) {
    water = imageLoad(water_in, at + water_ghosts);
    real bed = imageLoad(bed_in, at + water_ghosts).x;
    return water_cell(water, bed, water_velocity(water.x, real2(water.w, water.z)));
}

WaterCell load_turned(int2 at) {
    real4 water;
    return water_turned(load_cell(at, water));
}

WaterFace face_between(WaterCell before, WaterCell a, WaterSlope slope_a, WaterCell b, WaterSlope slope_b, WaterCell behind) {
    return water_face(a, slope_a, b, slope_b, water_face_rests(before, a, b, behind));
}

void main() {
    int tile = int(listed_tiles[gl_WorkGroupID.y]);
    int2 first = int2(tile % tiles.x, tile / tiles.x) * tile_samples + int2(int(gl_LocalInvocationIndex), int(gl_WorkGroupID.x) * strip_rows);
    int rows = min(strip_rows, samples.y - first.y);
    real dt = clock_dt_s;
    bool moved = false;
    bool moved_high = false;  // within reach of the tile's first row
    bool moved_low = false;
    real fastest = real(0);
#ifdef SOURCES
    dvec2 sources = dvec2(0.0);
#endif

    if (first.x < samples.x && rows > 0) {
        real4 here;
        real4 below;
        real4 ignored;
        WaterCell north_2 = load_cell(first + int2(0, -2), ignored);
        WaterCell north = load_cell(first + int2(0, -1), ignored);
        WaterCell cell = load_cell(first, here);
        WaterCell south = load_cell(first + int2(0, 1), below);
        WaterSlope slope = water_slope(south, cell, north);
        WaterFace face_north = face_between(south, cell, slope, north, water_slope(cell, north, north_2), north_2);
#ifdef SEDIMENT
        real solid_here = load_concentration(first, cell.depth);
        real solid_south = load_concentration(first + int2(0, 1), south.depth);
        real solid_north = sediment_flux(face_north.mass, solid_here, load_concentration(first + int2(0, -1), north.depth));
#endif
        int row = 0;
        do {
            int2 at = first + int2(0, row);
            real4 next;
            WaterCell south_2 = load_cell(at + int2(0, 2), next);
            WaterSlope slope_south = water_slope(south_2, south, cell);
            WaterFace face_south = face_between(south_2, south, slope_south, cell, slope, north);

            WaterCell west_2 = load_turned(at + int2(-2, 0));
            WaterCell west = load_turned(at + int2(-1, 0));
            WaterCell turned = water_turned(cell);
            WaterCell east = load_turned(at + int2(1, 0));
            WaterCell east_2 = load_turned(at + int2(2, 0));
            WaterSlope slope_x = water_slope(west, turned, east);
            WaterFace face_west = face_between(west_2, west, water_slope(west_2, west, turned), turned, slope_x, east);
            WaterFace face_east = face_between(west, turned, slope_x, east, water_slope(turned, east, east_2), east_2);

            WaterChange change = water_change(here.x, face_west, face_east, face_south, face_north);
#if ORDER == 2 && STAGE == 2
            real4 start = imageLoad(water_out, at + water_ghosts);
#else
            real4 start = here;
#endif
            real4 after = water_after_stage(STAGE, start, here, change);
#ifdef SOURCES
            real loss = water_loss(after, dt);
#ifdef RAIN_MAP
            real4 paint = imageLoad(painted, at);
            precise real rain = water_rain(paint.y, paint.z) * dt;
            sources += dvec2(double(loss), double(rain));
#else
            precise real rain = rain_m_per_s * dt;
            sources.x += double(loss);
#endif
            after = water_with_sources(after, rain, loss);
#endif
#if STAGE == 2
            // Of what stays: a run that is saved and loaded finds the same.
            fastest = max(fastest, water_speed(after));
#endif
            // By its bits: a resting -0 becomes 0.
            bool moves = !change.rests || (floatBitsToUint(here.z) | floatBitsToUint(here.w)) != 0u;
#ifdef SOURCES
            moves = moves || after.x > real(0) || loss > real(0);
#endif
            moved = moved || moves;
            int row_in_tile = int(gl_WorkGroupID.x) * strip_rows + row;
            moved_high = moved_high || (moves && row_in_tile < water_reach);
            moved_low = moved_low || (moves && row_in_tile >= tile_samples - water_reach);
            imageStore(water_out, at + water_ghosts, after);
#ifdef SEDIMENT
            real flux_south = sediment_flux(face_south.mass, solid_south, solid_here);
            real flux_west = sediment_flux(face_west.mass, load_concentration(at + int2(-1, 0), west.depth), solid_here);
            real flux_east = sediment_flux(face_east.mass, solid_here, load_concentration(at + int2(1, 0), east.depth));
            real solid_gain = sediment_gain(flux_west, flux_east, flux_south, solid_north);
            real2 load_here = imageLoad(load_in, at + water_ghosts).xy;
#if ORDER == 2 && STAGE == 2
            real2 load_start = imageLoad(load_out, at + water_ghosts).xy;
#else
            real2 load_start = load_here;
#endif
            real2 load = sediment_after_stage(STAGE, load_start, load_here, solid_gain);
            imageStore(load_out, at + water_ghosts, real4(load.x, load.y, 0.0, 0.0));
            solid_north = flux_south;
            solid_here = solid_south;
            solid_south = load_concentration(at + int2(0, 2), south_2.depth);
#endif

            north = cell;
            cell = south;
            south = south_2;
            here = below;
            below = next;
            slope = slope_south;
            face_north = face_south;
            ++row;
        } while (row < rows);
    }
    if (moved) {
        int column = int(gl_LocalInvocationIndex);
        uint awake = wet | (moved_high ? wet_north : 0u) | (moved_low ? wet_south : 0u) |
                     (column < water_reach ? wet_west : 0u) | (column >= tile_samples - water_reach ? wet_east : 0u);
        if ((water_activity[tile] & awake) != awake) atomicOr(water_activity[tile], awake);
        stamp_tile(tile, tile_water);
    }
#if STAGE == 2
    if (fastest > real(0)) atomicMax(tile_speeds[tile], floatBitsToUint(fastest));
#endif
#ifdef SOURCES
    column_sources[gl_LocalInvocationIndex] = sources;
    barrier();
    if (gl_LocalInvocationIndex == 0u) {
        dvec2 sum = dvec2(0.0);
        for (int i = 0; i < tile_samples; ++i) sum += column_sources[i];
        tile_sources[tile * tile_strips + int(gl_WorkGroupID.x)] += sum;
    }
#endif
}

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
#ifdef LAND_COVER
layout(rgba32f) uniform readonly image2D land_cover;
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
#ifdef LAND_COVER
#include "maths/land_cover.glsl"
#endif
#ifdef FLOW_MAP
#include "maths/water_flow.glsl"
layout(rg32f) uniform image2D flow_map;
#endif
#ifdef INFLOW
#include "maths/edge_kinds.glsl"
#include "maths/water_given_face.glsl"
#include "maths/edge_places.glsl"
#include "sim/water_inflow.glsl"
#endif
#ifdef SEDIMENT
#include "maths/sediment_transport.glsl"

// Concentration of a sample's suspended load, by volume.
real load_concentration(int2 at, real depth) { return sediment_concentration(depth, imageLoad(load_in, at + water_ghosts).x); }
#endif

#include "sim/water_faces.glsl"

// What an invocation keeps while it marches: of its column the sample of a row and those around it, and the face behind.
struct March {
    WaterCell north;
    WaterCell cell;
    WaterCell south;
    WaterSlope slope;
    WaterFace face_north;
    real4 here;  // the texels of cell and south
    real4 below;
#ifdef SEDIMENT
    real solid_here;  // concentrations
    real solid_south;
    real flux_north;  // of solid
#endif
};

March march_from(int2 first) {
    March m;
    real4 ignored;
    WaterCell north_2 = load_cell(first + int2(0, -2), ignored);
    m.north = load_cell(first + int2(0, -1), ignored);
    m.cell = load_cell(first, m.here);
    m.south = load_cell(first + int2(0, 1), m.below);
    m.slope = water_slope(m.south, m.cell, m.north);
    m.face_north = face_between(m.south, m.cell, m.slope, m.north, water_slope(m.cell, m.north, north_2), north_2);
#ifdef INFLOW
    m.face_north = water_given_face(m.face_north, first.y == 0, edge_kind_north, -inflow_at(edge_index(0, first.x)));
#endif
#ifdef SEDIMENT
    m.solid_here = load_concentration(first, m.cell.depth);
    m.solid_south = load_concentration(first + int2(0, 1), m.south.depth);
    m.flux_north = sediment_flux(m.face_north.mass, m.solid_here, load_concentration(first + int2(0, -1), m.north.depth));
#endif
    return m;
}

// The faces of a row's sample, and what stands beyond them.
struct Across {
    WaterCell west;
    WaterCell east;
    WaterFace face_west;
    WaterFace face_east;
};

Across across(int2 at, WaterCell cell) {
    Across a;
    WaterCell west_2 = load_turned(at + int2(-2, 0));
    a.west = load_turned(at + int2(-1, 0));
    WaterCell turned = water_turned(cell);
    a.east = load_turned(at + int2(1, 0));
    WaterCell east_2 = load_turned(at + int2(2, 0));
    WaterSlope slope = water_slope(a.west, turned, a.east);
    a.face_west = face_between(west_2, a.west, water_slope(west_2, a.west, turned), turned, slope, a.east);
    a.face_east = face_between(a.west, turned, slope, a.east, water_slope(turned, a.east, east_2), east_2);
#ifdef INFLOW
    a.face_west = water_given_face(a.face_west, at.x == 0, edge_kind_west, inflow_at(edge_index(2, at.y)));
    a.face_east = water_given_face(a.face_east, at.x == samples.x - 1, edge_kind_east, -inflow_at(edge_index(3, at.y)));
#endif
    return a;
}

#ifdef SOURCES
// Rain, and a loss of so much a second, in dt seconds, which the sums take too. True where either was.
bool add_sources(int2 at, real loss_rate, real dt, inout real4 water, inout dvec2 sources) {
    real loss = water_loss(water, loss_rate, dt);
#ifdef RAIN_MAP
    real4 paint = imageLoad(painted, at);
    precise real rain = water_rain(clock_rain, paint.y, paint.z) * dt;
    sources += dvec2(double(loss), double(rain));
#else
    precise real rain = clock_rain * dt;
    sources.x += double(loss);
#endif
    water = water_with_sources(water, rain, loss);
    return rain > real(0) || loss > real(0);
}
#endif

#ifdef SEDIMENT
// The load of a row's sample after the stage. Gives the flux of solid over its southern face.
real step_load(int2 at, March m, Across a, real mass_south) {
    real flux_south = sediment_flux(mass_south, m.solid_south, m.solid_here);
    real flux_west = sediment_flux(a.face_west.mass, load_concentration(at + int2(-1, 0), a.west.depth), m.solid_here);
    real flux_east = sediment_flux(a.face_east.mass, m.solid_here, load_concentration(at + int2(1, 0), a.east.depth));
    real solid_gain = sediment_gain(flux_west, flux_east, flux_south, m.flux_north);
    real2 load_here = imageLoad(load_in, at + water_ghosts).xy;
#if ORDER == 2 && STAGE == 2
    real2 load_start = imageLoad(load_out, at + water_ghosts).xy;
#else
    real2 load_start = load_here;
#endif
    real2 load = sediment_after_stage(STAGE, load_start, load_here, solid_gain);
    imageStore(load_out, at + water_ghosts, real4(load.x, load.y, 0.0, 0.0));
    return flux_south;
}
#endif

// Marks a tile in which water moved, and the neighbours within whose reach it did.
void mark_awake(int tile, bool moved_high, bool moved_low) {
    int column = int(gl_LocalInvocationIndex);
    uint awake = wet | (moved_high ? wet_north : 0u) | (moved_low ? wet_south : 0u) |
                 (column < water_reach ? wet_west : 0u) | (column >= tile_samples - water_reach ? wet_east : 0u);
    if ((water_activity[tile] & awake) != awake) atomicOr(water_activity[tile], awake);
    stamp_tile(tile, tile_water);
}

void main() {
    int tile = int(listed_tiles[gl_WorkGroupID.y]);
    int first_row = int(gl_WorkGroupID.x) * strip_rows;  // in the tile
    int2 first = int2(tile % tiles.x, tile / tiles.x) * tile_samples + int2(int(gl_LocalInvocationIndex), first_row);
    int rows = min(strip_rows, samples.y - first.y);
    bool moved = false;
    bool moved_high = false;  // within reach of the tile's first row
    bool moved_low = false;
    real fastest = real(0);
#ifdef SOURCES
    real dt = clock_dt_s;
    dvec2 sources = dvec2(0.0);
#endif

    if (first.x < samples.x && rows > 0) {
        March m = march_from(first);
        int row = 0;
        do {
            int2 at = first + int2(0, row);
            real4 next;
            WaterCell south_2 = load_cell(at + int2(0, 2), next);
            WaterSlope slope_south = water_slope(south_2, m.south, m.cell);
            WaterFace face_south = face_between(south_2, m.south, slope_south, m.cell, m.slope, m.north);
#ifdef INFLOW
            face_south = water_given_face(face_south, at.y == samples.y - 1, edge_kind_south, inflow_at(edge_index(1, at.x)));
#endif
            Across a = across(at, m.cell);
#ifdef LAND_COVER
            real4 cover = imageLoad(land_cover, at);
            precise real slows = clock_dt_s * land_cover_roughness(cover);
            water_friction = slows;
#endif
            WaterChange change = water_change(m.here.x, a.face_west, a.face_east, face_south, m.face_north);
#if ORDER == 2 && STAGE == 2
            real4 start = imageLoad(water_out, at + water_ghosts);
#else
            real4 start = m.here;
#endif
            real4 after = water_after_stage(STAGE, start, m.here, change);
            // By its bits: a resting -0 becomes 0.
            bool moves = !change.rests || (floatBitsToUint(m.here.z) | floatBitsToUint(m.here.w)) != 0u;
#ifdef SOURCES
#ifdef LAND_COVER
            real loss_rate = land_cover_loss(cover);
#else
            real loss_rate = loss_m_per_s;
#endif
            bool changed = add_sources(at, loss_rate, dt, after, sources);
            moves = moves || changed;
#endif
#if STAGE == 2
            // Of what stays: a run that is saved and loaded finds the same.
            fastest = max(fastest, water_speed(after));
#endif
            moved = moved || moves;
            moved_high = moved_high || (moves && first_row + row < water_reach);
            moved_low = moved_low || (moves && first_row + row >= tile_samples - water_reach);
            imageStore(water_out, at + water_ghosts, after);
#ifdef FLOW_MAP
            real outflow = water_outflow(a.face_west, a.face_east, face_south, m.face_north);
            if (outflow > real(0)) {
                real2 flow = flow_counted(imageLoad(flow_map, at).xy, outflow);
                imageStore(flow_map, at, real4(flow.x, flow.y, 0.0, 0.0));
            }
#endif
#ifdef SEDIMENT
            m.flux_north = step_load(at, m, a, face_south.mass);
            m.solid_here = m.solid_south;
            m.solid_south = load_concentration(at + int2(0, 2), south_2.depth);
#endif
            m.north = m.cell;
            m.cell = m.south;
            m.south = south_2;
            m.here = m.below;
            m.below = next;
            m.slope = slope_south;
            m.face_north = face_south;
            ++row;
        } while (row < rows);
    }
    if (moved) mark_awake(tile, moved_high, moved_low);
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

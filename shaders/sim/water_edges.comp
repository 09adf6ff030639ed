// Before a stage: the ghost samples beyond the map's edges, what passes the edges in this stage, booked in double, and
// the springs. One group goes round the map; after the tick's time is over it does nothing.
layout(local_size_x = 256) in;
#include "sim/tile_samples.glsl"
#include "sim/water_images.glsl"

layout(rgba32f) coherent uniform image2D water_state;
layout(r32f) uniform image2D bed;
#include "sim/tile_stamps.glsl"
layout(std430) readonly buffer Springs { vec4 springs[]; };          // column, row, m/s
layout(std430) readonly buffer TickSeries { float tick_series[]; };  // of maths/tick_series.glsl
layout(std430) readonly buffer BedBeyond { float bed_beyond[]; };    // m; of each place the nearer and the further ghost's
#ifdef SEDIMENT
layout(rg32f) coherent uniform image2D load_state;
layout(std430) buffer EdgeSolidBooks { dvec2 edge_solid_books[]; };  // metres in, out, as they count for the bed
layout(std140) uniform SedimentNumbers {
#include "maths/sediment_numbers.glsl"
};
#endif
layout(std430) buffer EdgeBooks { dvec2 edge_books[]; };             // metres in, out, round the map

uniform int stage;          // 1: of the sub-step's start, 2: of its second half

const int water_order = ORDER;
const real2 water_share = real2(0.0);
real water_drain = clock_drain;
const real water_friction = real(0);
real edge_inflow = real(0);  // of the place that is looked at
real edge_wave_m = real(0);
real edge_level_m = real(0);
real edge_sea_m = real(0);
#include "sim/cube_root_seed.glsl"
#include "maths/water.glsl"
real load_tick_series(int at) { return tick_series[at]; }
#include "maths/tick_series_values.glsl"
#include "maths/water_edge.glsl"
#include "maths/water_spring.glsl"
#include "maths/water_given_face.glsl"

real4 load_water(int2 at) { return imageLoad(water_state, at + water_ghosts); }
real load_bed_beyond(int at) { return bed_beyond[at]; }
real load_bed(int2 at) { return imageLoad(bed, at + water_ghosts).x; }
#include "maths/water_ghosts.glsl"
#include "sim/water_inflow.glsl"

void store_ghost(int2 at, int2 outward, EdgeSample ghost) {
    imageStore(water_state, at + water_ghosts, edge_water(ghost, outward));
    imageStore(bed, at + water_ghosts, vec4(ghost.bed));
}

// Cells in the order of the axis that points outwards.
WaterCell outward_cell(EdgeSample s) {
    return water_cell(real4(s.depth, 0.0, s.outward, s.beside), s.bed, water_velocity(s.depth, real2(s.outward, s.beside)));
}

#ifdef SEDIMENT
#include "maths/sediment_transport.glsl"
#endif

void main() {
    if (clock_dt_s <= real(0)) return;
    int me = int(gl_LocalInvocationIndex);
    precise real share = stage == 1 ? clock_at : clock_at + clock_share;
    edge_wave_m = tick_series_at(series_wave, share);
    edge_level_m = tick_series_at(series_level, share);
    edge_sea_m = has_sea == 1 ? edge_level_m : no_sea;
    double weight = ORDER == 2 ? 0.5lf : 1.0lf;

    // Springs first: what they give takes part at once. One after the other, for two may share a sample.
    if (stage == 1 && me == 0)
        for (int i = 0; i < spring_count; ++i) {
            int2 at = int2(springs[i].xy) + water_ghosts;
            real gain = spring_gain(springs[i].z, clock_dt_s);
            imageStore(water_state, at, water_with_spring(imageLoad(water_state, at), gain));
            book_springs_m += double(gain);
            // Also where so little comes that it rests.
            int2 tile = int2(springs[i].xy) / tile_samples;
            stamp_tile(tile.y * tiles.x + tile.x, tile_water);
        }
    memoryBarrierImage();
    barrier();

    for (int index = me; index < edge_places(); index += 256) {
        edge_inflow = inflow_at(index);
        EdgeGhosts made = edge_ghosts(index);
        EdgePlace place = made.place;
        store_ghost(place.at + place.outward, place.outward, made.ghost);
        store_ghost(place.at + 2 * place.outward, place.outward, made.ghost_2);
#ifdef SEDIMENT
        real ghost_load = edge_load(made, imageLoad(load_state, made.shown_at + water_ghosts).x, sediment_inflow);
        imageStore(load_state, place.at + place.outward + water_ghosts, real4(ghost_load, 0.0, 0.0, 0.0));
#endif
        if (edge_mirrors(made.kind)) continue;

        // What comes in counts for the length of the next sub-step.
        real speed = water_speed(real4(made.ghost.depth, 0.0, made.ghost.outward, made.ghost.beside));
        atomicMax(clock_edge_fastest, floatBitsToUint(speed));
        WaterCell a_2 = outward_cell(made.inside_2);
        WaterCell a = outward_cell(made.inside);
        WaterCell b = outward_cell(made.ghost);
        WaterCell b_2 = outward_cell(made.ghost_2);
        bool rests = water_face_rests(a_2, a, b, b_2);
        WaterFace face = water_face(a, water_slope(a_2, a, b), b, water_slope(a, b, b_2), rests);
        face = water_given_face(face, true, made.kind, -edge_inflow);
        real share_across = place.outward.x != 0 ? clock_share_x : clock_share_y;
        precise real metres = share_across * face.mass;
#ifdef SEDIMENT
        real within = sediment_concentration(made.inside.depth, imageLoad(load_state, place.at + water_ghosts).x);
        real beyond = sediment_concentration(made.ghost.depth, ghost_load);
        precise real solid = (share_across * sediment_flux(face.mass, within, beyond)) * sediment_speedup;
        edge_solid_books[index] += weight * dvec2(max(-double(solid), 0.0lf), max(double(solid), 0.0lf));
#endif
        edge_books[index] += weight * dvec2(max(-double(metres), 0.0lf), max(double(metres), 0.0lf));
    }
}

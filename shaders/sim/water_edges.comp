// Before a stage: the ghost samples beyond the map's edges, what passes the edges in this stage, booked in double, and
// the springs. One group goes round the map; after the tick's time is over it does nothing.
layout(local_size_x = 256) in;
#include "sim/tile_samples.glsl"
#include "sim/water_images.glsl"

layout(rgba32f) coherent uniform image2D water_state;
layout(r32f) uniform image2D bed;
#include "sim/tile_stamps.glsl"
layout(std430) readonly buffer Springs { vec4 springs[]; };          // column, row, m/s
layout(std430) readonly buffer EdgeSeries { float edge_series[]; };  // inflow, m²/s; then wave, m
#ifdef SEDIMENT
layout(rg32f) coherent uniform image2D load_state;
layout(std430) buffer EdgeSolidBooks { dvec2 edge_solid_books[]; };  // metres in, out, as they count for the bed
uniform real edge_concentration;  // of what flows in by edges of kind inflow
uniform real sediment_speedup;
#endif
layout(std430) buffer EdgeBooks { dvec2 edge_books[]; };             // metres in, out, round the map

uniform int2 samples;
uniform int2 tiles;
uniform int stage;          // 0: of the sub-step's start, 1: of its second half
uniform int kind_north;     // of maths/edge_kinds.glsl
uniform int kind_south;
uniform int kind_west;
uniform int kind_east;
uniform int edge_series_steps;
uniform real edge_level_m;
uniform real gravity;
uniform int spring_count;
uniform int eulers;         // Euler steps in a sub-step, as in water_step.comp

const int water_order = ORDER;
real water_gravity = gravity;
const real2 water_share = real2(0.0);
const real2 water_fastest = real2(0.0);
real water_drain = clock_drain;
const real water_friction = real(0);
real edge_inflow = real(0);
real edge_wave_m = real(0);
#include "sim/cube_root_seed.glsl"
#include "maths/water.glsl"
real load_edge_series(int at) { return edge_series[at]; }
#include "maths/water_edge.glsl"

// The edge at `index` of the way round: the sample inside, and the step outwards.
void edge_at(int index, out int2 at, out int2 outward, out int kind) {
    if (index < 2 * samples.x) {
        bool north = index < samples.x;
        at = int2(north ? index : index - samples.x, north ? 0 : samples.y - 1);
        outward = int2(0, north ? -1 : 1);
        kind = north ? kind_north : kind_south;
    } else {
        int row = index - 2 * samples.x;
        bool west = row < samples.y;
        at = int2(west ? 0 : samples.x - 1, west ? row : row - samples.y);
        outward = int2(west ? -1 : 1, 0);
        kind = west ? kind_west : kind_east;
    }
}

EdgeSample load_sample(int2 at, int2 outward) {
    real4 water = imageLoad(water_state, at + water_ghosts);
    // Rows run southwards, discharge north.
    real along = outward.x != 0 ? water.z : -water.w;
    EdgeSample inside;
    inside.depth = water.x;
    inside.outward = outward.x + outward.y > 0 ? along : -along;
    inside.beside = outward.x != 0 ? water.w : water.z;
    inside.bed = imageLoad(bed, at + water_ghosts).x;
    return inside;
}

void store_ghost(int2 at, int2 outward, EdgeSample ghost) {
    real along = outward.x + outward.y > 0 ? ghost.outward : -ghost.outward;
    real4 water = outward.x != 0 ? real4(ghost.depth, 0.0, along, ghost.beside) : real4(ghost.depth, 0.0, ghost.beside, -along);
    imageStore(water_state, at + water_ghosts, water);
    imageStore(bed, at + water_ghosts, vec4(ghost.bed));
}

// Cells in the order of the axis that points outwards.
WaterCell outward_cell(EdgeSample s) {
    return water_cell(real4(s.depth, 0.0, s.outward, s.beside), s.bed, water_velocity(s.depth, real2(s.outward, s.beside)));
}

#ifdef SEDIMENT
#include "maths/sediment_transport.glsl"

// The nearer ghost's load: that of the far side, to the bit, of an inflow, or none.
real load_of_ghost(int kind, int2 shown_at, real depth) {
    if (kind == edge_periodic) return imageLoad(load_state, shown_at + water_ghosts).x;
    precise real inflow = edge_concentration * depth;
    return kind == edge_inflow_kind ? inflow : real(0);
}
#endif

void main() {
    if (clock_dt_s <= real(0)) return;
    int me = int(gl_LocalInvocationIndex);
    precise real share = stage == 0 ? clock_at : clock_at + clock_share;
    edge_inflow = edge_series_at(0, share);
    edge_wave_m = edge_series_at(1, share);
    double weight = ORDER == 2 ? 0.5lf : 1.0lf;

    // Springs first: what they give takes part at once. One after the other, for two may share a sample.
    if (stage == 0 && me == 0)
        for (int i = 0; i < spring_count; ++i) {
            int2 at = int2(springs[i].xy) + water_ghosts;
            real4 water = imageLoad(water_state, at);
            precise real gain = springs[i].z * (clock_dt_s * real(eulers));
            real2 depth = add_increment(real2(water.x, water.y), gain);
            imageStore(water_state, at, real4(depth.x, depth.y, water.z, water.w));
            book_springs_m += double(gain);
            // Also where so little comes that it rests.
            int2 tile = int2(springs[i].xy) / tile_samples;
            stamp_tile(tile.y * tiles.x + tile.x, tile_water);
        }
    memoryBarrierImage();
    barrier();

    int count = 2 * (samples.x + samples.y);
    for (int index = me; index < count; index += 256) {
        int2 at;
        int2 outward;
        int kind;
        edge_at(index, at, outward, kind);
        EdgeSample inside = load_sample(at, outward);
        EdgeSample inside_2 = load_sample(at - outward, outward);
        kind = edge_acts_as(kind, inside);
        EdgeSample shown = inside;
        EdgeSample shown_2 = inside_2;
        int2 shown_at = at;
        if (kind == edge_periodic) {
            int2 far = outward.x != 0 ? int2(samples.x - 1 - at.x, at.y) : int2(at.x, samples.y - 1 - at.y);
            shown_at = far;
            shown = load_sample(far, outward);
            shown_2 = load_sample(far + outward, outward);
        }
        EdgeSample ghost = edge_ghost(kind, shown);
        EdgeSample ghost_2 = ghost;
        if (kind == edge_wall || kind == edge_periodic) ghost_2 = edge_ghost(kind, shown_2);
        precise real fall = edge_fall(kind, inside, inside_2);
        precise real bed_1 = ghost.bed - fall;
        precise real bed_2 = ghost_2.bed - (fall + fall);
        ghost.bed = bed_1;
        ghost_2.bed = bed_2;
        store_ghost(at + outward, outward, ghost);
        store_ghost(at + 2 * outward, outward, ghost_2);
#ifdef SEDIMENT
        real ghost_load = load_of_ghost(kind, shown_at, ghost.depth);
        imageStore(load_state, at + outward + water_ghosts, real4(ghost_load, 0.0, 0.0, 0.0));
#endif
        if (kind == edge_wall || kind == edge_periodic) continue;

        // What comes in counts for the length of the next sub-step.
        real speed = water_speed(real4(ghost.depth, 0.0, ghost.outward, ghost.beside));
        atomicMax(clock_edge_fastest, floatBitsToUint(speed));
        WaterCell a_2 = outward_cell(inside_2);
        WaterCell a = outward_cell(inside);
        WaterCell b = outward_cell(ghost);
        WaterCell b_2 = outward_cell(ghost_2);
        bool rests = water_face_rests(a_2, a, b, b_2);
        WaterFace face = water_face(a, water_slope(a_2, a, b), b, water_slope(a, b, b_2), rests);
        real share_across = outward.x != 0 ? clock_share_x : clock_share_y;
        precise real metres = share_across * face.mass;
#ifdef SEDIMENT
        real within = sediment_concentration(inside.depth, imageLoad(load_state, at + water_ghosts).x);
        real beyond = sediment_concentration(ghost.depth, ghost_load);
        precise real solid = (share_across * sediment_flux(face.mass, within, beyond)) * sediment_speedup;
        edge_solid_books[index] += weight * dvec2(max(-double(solid), 0.0lf), max(double(solid), 0.0lf));
#endif
        edge_books[index] += weight * dvec2(max(-double(metres), 0.0lf), max(double(metres), 0.0lf));
    }
}

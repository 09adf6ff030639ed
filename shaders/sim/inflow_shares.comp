// How the inflow spreads along each edge in a tick, by conveyance: a group for each side of the map.
layout(local_size_x = 256) in;
#include "sim/tile_samples.glsl"
#include "sim/water_images.glsl"

layout(r32f) uniform readonly image2D bed;
#ifdef LAND_COVER
layout(rgba32f) uniform readonly image2D land_cover;
#endif
layout(std430) writeonly buffer InflowShares { float inflow_shares[]; };  // of each of the edges' places, 1 on average

#include "sim/cube_root_seed.glsl"
#include "maths/cube_root.glsl"
#include "maths/edge_kind_of.glsl"
#include "maths/edge_kinds.glsl"
#include "maths/edge_places.glsl"
#ifdef LAND_COVER
#include "maths/land_cover.glsl"
real load_manning(int2 at) { return land_cover_manning(imageLoad(land_cover, at)); }
#else
real load_manning(int2 at) { return water_manning; }
#endif
real load_bed(int2 at) { return imageLoad(bed, at + water_ghosts).x; }
#include "maths/conveyance.glsl"

shared real lanes[conveyance_lanes];
shared real together;

real lowest_of_all() {
    real lowest = lanes[0];
    for (int lane = 1; lane < conveyance_lanes; ++lane) lowest = min(lowest, lanes[lane]);
    return lowest;
}

real sum_of_all() {
    real sum = real(0);
    for (int lane = 0; lane < conveyance_lanes; ++lane) {
        precise real next = sum + lanes[lane];
        sum = next;
    }
    return sum;
}

void main() {
    int side = int(gl_WorkGroupID.x);
    int me = int(gl_LocalInvocationIndex);
    if (edge_kind_of(side) != edge_inflow_kind) return;  // the whole group
    lanes[me] = conveyance_lowest(side, me);
    barrier();
    if (me == 0) together = lowest_of_all();
    barrier();
    real lowest = together;
    ConveyanceSearch search = conveyance_search();
    int halvings = 0;
    for (int i = 0; i < conveyance_doublings + conveyance_halvings && halvings < conveyance_halvings; ++i) {
        barrier();
        lanes[me] = conveyance_sum(side, me, lowest, search.level);
        barrier();
        if (me == 0) together = sum_of_all();
        barrier();
        search = conveyance_next(search, side, together);
        halvings += search.doubles ? 0 : 1;
    }
    barrier();
    lanes[me] = conveyance_sum(side, me, lowest, search.high);
    barrier();
    if (me == 0) together = sum_of_all();
    barrier();
    // Over dry ground a sub-step would be as long as the tick.
    if (me == 0) atomicMax(clock_edge_fastest, floatBitsToUint(conveyance_speed(search.high)));
    for (int i = me; i < conveyance_count(side); i += conveyance_lanes) {
        int place = edge_index(side, i);
        inflow_shares[place] = conveyance_share(side, place, lowest, search.high, together);
    }
}

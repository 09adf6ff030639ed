// The inflow at a place of the edges (maths/edge_places.glsl), m²/s into the map. CONVEYANCE: not the same at all. Needs
// sim/water_images.glsl.
#ifdef CONVEYANCE
layout(std430) readonly buffer InflowShares { float inflow_shares[]; };  // of each place, 1 on average
real inflow_at(int place) {
    precise real inflow = clock_inflow * inflow_shares[place];
    return inflow;
}
#else
real inflow_at(int place) { return clock_inflow; }
#endif

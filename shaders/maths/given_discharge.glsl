// What passes a face of the map's edge, m²/s. At an edge of kind inflow it is what is given, exactly. HLL's flux between the
// sample inside and its ghost is that only where the water inside is steady. Needs maths/edge_kinds.glsl.

// `given`: into the map, with the sign that the face counts by; 0: the edge is a wall.
real water_given_discharge(real mass, bool at_edge, int kind, real given) {
    return at_edge && kind == edge_inflow_kind && given != real(0) ? given : mass;
}

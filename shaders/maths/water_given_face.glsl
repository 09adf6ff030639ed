// A face of the map's edge where the discharge is given, m²/s: it passes that exactly. HLL's flux between the sample inside and its
// ghost is that only where the water inside is steady. Needs maths/edge_kinds.glsl and maths/water.glsl.

// `given`: into the map, with the sign that the face counts by; 0: the edge is a wall. Water moves there, however little it is.
WaterFace water_given_face(WaterFace face, bool at_edge, int kind, real given) {
    bool is_given = at_edge && kind == edge_inflow_kind && given != real(0);
    WaterFace passes = face;
    passes.mass = is_given ? given : face.mass;
    passes.rests = face.rests && !is_given;
    return passes;
}

// What lies beyond an edge of the map, by the kind of the edge and the sample inside (docs/numerics.md, "Edges of the water"). Needs maths/water.glsl, and
//   the numbers of maths/water_numbers.glsl
//   edge_inflow      real, m²/s into the map at inflow edges
//   edge_wave_m      real, the wave's height above the still level at wave edges
//   edge_level_m     real, m: held at level edges, still level at wave edges
//   edge_sea_m       real, m: level of the sea that stands beyond open edges; far below all ground: none does

#include "maths/edge_kinds.glsl"

// A sample as an edge sees it: depth, discharge out of the map, discharge along the edge, bed.
struct EdgeSample {
    real depth;
    real outward;
    real beside;
    real bed;
};

// A sample of this depth and outward velocity on the same bed.
EdgeSample edge_sample(EdgeSample like, real depth, real velocity) {
    precise real discharge = depth * velocity;
    EdgeSample ghost = like;
    ghost.depth = depth;
    ghost.outward = discharge;
    ghost.beside = real(0);
    return ghost;
}

// The ghost on this bed at another depth, as fast as it was.
EdgeSample edge_on_bed(EdgeSample ghost, real depth, real bed) {
    EdgeSample moved = ghost;
    moved.bed = bed;
    if (depth == ghost.depth) return moved;
    real2 velocity = water_velocity(ghost.depth, real2(ghost.outward, ghost.beside));
    precise real outward = depth * velocity.x;
    precise real beside = depth * velocity.y;
    moved.depth = depth;
    moved.outward = outward;
    moved.beside = beside;
    return moved;
}

// Depth over this bed where the ghost's level stays.
real edge_depth_at_its_level(EdgeSample ghost, real bed) {
    precise real depth = ghost.depth - (bed - ghost.bed);
    return max(depth, real(0));
}

real edge_celerity(real depth) {
    precise real square = water_gravity * depth;
    precise real celerity = sqrt(square);
    return celerity;
}

// The kind that an edge acts as. An inflow edge without inflow is a wall. An open edge is a wall where water runs into
// the map faster than a quarter of √(gh) and no sea stands beyond: a copied ghost would be a spring that feeds itself.
int edge_acts_as(int kind, EdgeSample inner, bool sea_beyond) {
    if (kind == edge_inflow_kind && edge_inflow <= real(0)) return edge_wall;
    real velocity = water_velocity(inner.depth, real2(inner.outward, inner.beside)).x;
    bool runs_in = velocity < real(-0.25) * edge_celerity(inner.depth);
    return kind == edge_open && runs_in && !sea_beyond ? edge_wall : kind;
}

// Where the bed falls, water flows on as deep as it is; where it rises, it stands no higher than inside.
real edge_depth_running_on(EdgeSample inner, real bed) { return min(edge_depth_at_its_level(inner, bed), inner.depth); }

// Beyond an open edge water runs on, but stands no lower than the sea where that stands beyond, if it stands as high inside.
EdgeSample edge_that_is_open(EdgeSample inner, real bed) {
    precise real sea = edge_sea_m - bed;
    real depth = max(edge_depth_running_on(inner, bed), min(edge_depth_at_its_level(inner, bed), sea));
    return edge_on_bed(inner, depth, bed);
}

// Ghost of an edge with a held level. The outgoing invariant u + 2c, over the bed inside, gives its velocity, which is at
// most critical over both beds.
EdgeSample edge_at_level(EdgeSample inner, real velocity, real bed) {
    precise real held = edge_level_m - inner.bed;
    precise real held_there = edge_level_m - bed;
    real depth = max(held, real(0));
    real depth_there = max(held_there, real(0));
    real c = edge_celerity(depth);
    real c_inner = edge_celerity(inner.depth);
    if (velocity >= c_inner && inner.depth > real(0)) return edge_on_bed(inner, edge_depth_running_on(inner, bed), bed);
    precise real reached = velocity + real(2) * (c_inner - c);
    real fastest = min(c, edge_celerity(depth_there));
    return edge_on_bed(edge_sample(inner, depth, min(max(reached, -fastest), fastest)), depth_there, bed);
}

// A discharge that is given, above 0: c solves -q g / c² + 2c = u + 2c of the wave that leaves, by Newton from below.
EdgeSample edge_with_inflow(EdgeSample inner, real velocity) {
    precise real outgoing = velocity + real(2) * edge_celerity(inner.depth);
    precise real weight = edge_inflow * water_gravity;
    precise real half_weight = real(0.5) * weight;
    precise real start = real(1) / inverse_cube_root(half_weight);
    precise real c = max(start, real(0.5) * outgoing);
    if (outgoing > real(0)) {
        for (int i = 0; i < 8; ++i) {
            precise real square = c * c;
            precise real part = weight / square;
            precise real miss = (real(2) * c - part) - outgoing;
            precise real steepness = real(2) + (part + part) / c;
            c = c - miss / steepness;
        }
    }
    precise real depth = (c * c) / water_gravity;
    precise real inward = edge_inflow / depth;
    return edge_sample(inner, depth, -inward);
}

// A simple wave enters, u = 2 (c - c0), and what comes from inside leaves: u = (in + out) / 2, c = (out - in) / 4.
EdgeSample edge_with_wave(EdgeSample inner, real velocity, real bed) {
    precise real still = edge_level_m - inner.bed;
    precise real wave = still + edge_wave_m;
    real c_still = edge_celerity(max(still, real(0)));
    real c_wave = edge_celerity(max(wave, real(0)));
    precise real entering = real(2) * c_still - real(4) * c_wave;
    precise real leaving = velocity + real(2) * edge_celerity(inner.depth);
    precise real u = real(0.5) * (leaving + entering);
    precise real c = max(real(0.25) * (leaving - entering), real(0));
    precise real depth = (c * c) / water_gravity;
    // A wall, where there is no water to move.
    if (still <= real(0)) return edge_sample(inner, inner.depth, -velocity);
    EdgeSample ghost = edge_sample(inner, depth, u);
    return edge_on_bed(ghost, edge_depth_at_its_level(ghost, bed), bed);
}

// Fall of the bed from sample to sample beyond an open edge where it is not known. Where water cascades out over drops
// greater than its depth, the bed falls as the level does inside. Elsewhere the bed stays level, so that water at rest inside
// stays at rest.
real edge_fall(int kind, EdgeSample inner, EdgeSample before) {
    precise real fall = (before.depth - inner.depth) + (before.bed - inner.bed);
    bool cascades = inner.outward > real(0) && before.depth > water_film && fall > inner.depth;
    return kind == edge_open && cascades ? fall : real(0);
}

// Kinds of edges beyond which the bed is the real one. The others show samples of the map, or give a discharge that must
// not hang on it.
bool edge_takes_bed(int kind) { return kind == edge_open || kind == edge_level || kind == edge_wave; }

// The ghost over this bed; for a wall or a periodic edge, `first` is the sample that it shows.
EdgeSample edge_ghost(int kind, EdgeSample first, real bed) {
    real velocity = water_velocity(first.depth, real2(first.outward, first.beside)).x;
    if (kind == edge_open) return edge_that_is_open(first, bed);
    if (kind == edge_level) return edge_at_level(first, velocity, bed);
    if (kind == edge_inflow_kind) return edge_with_inflow(first, velocity);
    if (kind == edge_wave) return edge_with_wave(first, velocity, bed);
    EdgeSample ghost = first;
    if (kind == edge_wall) ghost.outward = -first.outward;
    return ghost;
}

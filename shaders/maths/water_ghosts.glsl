// The two ghost samples beyond each sample of the map's edges (docs/numerics.md, "Edges of the water"). Needs
// maths/water_edge.glsl, and
//   real4 load_water(int2 at) and real load_bed(int2 at), ghost samples included
//   real load_bed_beyond(int): the real bed at the nearer and the further ghost of each place, or unknown_bed
#include "maths/bed_beyond.glsl"
#include "maths/edge_kind_of.glsl"
#include "maths/edge_places.glsl"

// Water as an edge sees it. Rows run southwards, discharge north.
EdgeSample edge_sample_at(int2 at, int2 outward) {
    real4 water = load_water(at);
    real along = outward.x != 0 ? water.z : -water.w;
    EdgeSample inside;
    inside.depth = water.x;
    inside.outward = outward.x + outward.y > 0 ? along : -along;
    inside.beside = outward.x != 0 ? water.w : water.z;
    inside.bed = load_bed(at);
    return inside;
}

real4 edge_water(EdgeSample ghost, int2 outward) {
    real along = outward.x + outward.y > 0 ? ghost.outward : -ghost.outward;
    return outward.x != 0 ? real4(ghost.depth, real(0), along, ghost.beside) : real4(ghost.depth, real(0), ghost.beside, -along);
}

// Edges of these kinds show samples of the map, and pass what those pass.
bool edge_mirrors(int kind) { return kind == edge_wall || kind == edge_periodic; }

struct EdgeGhosts {
    EdgePlace place;
    int kind;             // as it acts
    int2 shown_at;        // the sample that the nearer ghost is made from
    EdgeSample inside;
    EdgeSample inside_2;  // one further in
    EdgeSample ghost;
    EdgeSample ghost_2;   // one further out
};

bool edge_knows(real bed) { return bed > real(0.5) * real(unknown_bed); }

// Whether a sea stands beyond the edge: over the real bed, where that is known.
bool edge_has_sea(EdgeSample inside, real known_bed) { return (edge_knows(known_bed) ? known_bed : inside.bed) < edge_sea_m; }

// A ghost over the real bed where that counts and is known, else over a copy of the bed inside that has fallen so far.
EdgeSample edge_ghost_over(int kind, EdgeSample shown, real known_bed, real fall) {
    if (edge_takes_bed(kind) && edge_knows(known_bed)) return edge_ghost(kind, shown, known_bed);
    EdgeSample ghost = edge_ghost(kind, shown, shown.bed);
    precise real bed = ghost.bed - fall;
    ghost.bed = bed;
    return ghost;
}

EdgeGhosts edge_ghosts(int index) {
    EdgeGhosts made;
    EdgePlace place = edge_place(index);
    made.place = place;
    made.inside = edge_sample_at(place.at, place.outward);
    made.inside_2 = edge_sample_at(place.at - place.outward, place.outward);
    real known = load_bed_beyond(2 * index);
    real known_2 = load_bed_beyond(2 * index + 1);
    made.kind = edge_acts_as(edge_kind_of(place.side), made.inside, edge_has_sea(made.inside, known));
    made.shown_at = place.at;
    EdgeSample shown = made.inside;
    EdgeSample shown_2 = edge_mirrors(made.kind) ? made.inside_2 : made.inside;
    if (made.kind == edge_periodic) {
        bool rows = place.outward.x == 0;
        made.shown_at = int2(rows ? place.at.x : samples.x - 1 - place.at.x, rows ? samples.y - 1 - place.at.y : place.at.y);
        shown = edge_sample_at(made.shown_at, place.outward);
        shown_2 = edge_sample_at(made.shown_at + place.outward, place.outward);
    }
    precise real fall = edge_fall(made.kind, made.inside, made.inside_2);
    precise real fall_2 = fall + fall;
    made.ghost = edge_ghost_over(made.kind, shown, known, fall);
    made.ghost_2 = edge_ghost_over(made.kind, shown_2, edge_knows(known) && edge_knows(known_2) ? known_2 : known, fall_2);
    return made;
}

// The nearer ghost's load of solid, m: that of the sample it shows, to the bit, of an inflow of this concentration, or none.
real edge_load(EdgeGhosts made, real shown_load, real concentration) {
    precise real inflow = concentration * made.ghost.depth;
    if (made.kind == edge_periodic) return shown_load;
    return made.kind == edge_inflow_kind ? inflow : real(0);
}

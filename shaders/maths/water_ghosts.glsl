// The two ghost samples beyond each sample of the map's edges (docs/numerics.md, "Edges of the water"). Needs
// maths/water_edge.glsl, and
//   real4 load_water(int2 at) and real load_bed(int2 at), ghost samples included

// A place on the way round the map: the sample inside, the step out of the map, and the side.
struct EdgePlace {
    int2 at;
    int2 outward;
    int side;  // 0 north, 1 south, 2 west, 3 east
};

// Round the map are edge_places() of them: the rows in the north and south, then the columns in the west and east.
int edge_places() { return 2 * (samples.x + samples.y); }

int edge_kind_of(int side) {
    return side < 2 ? (side == 0 ? edge_kind_north : edge_kind_south) : (side == 2 ? edge_kind_west : edge_kind_east);
}

EdgePlace edge_place(int index) {
    EdgePlace place;
    if (index < 2 * samples.x) {
        bool north = index < samples.x;
        place.at = int2(north ? index : index - samples.x, north ? 0 : samples.y - 1);
        place.outward = int2(0, north ? -1 : 1);
        place.side = north ? 0 : 1;
    } else {
        int row = index - 2 * samples.x;
        bool west = row < samples.y;
        place.at = int2(west ? 0 : samples.x - 1, west ? row : row - samples.y);
        place.outward = int2(west ? -1 : 1, 0);
        place.side = west ? 2 : 3;
    }
    return place;
}

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
    int kind;             // as it acts
    int2 shown_at;        // the sample that the nearer ghost is made from
    EdgeSample inside;
    EdgeSample inside_2;  // one further in
    EdgeSample ghost;
    EdgeSample ghost_2;   // one further out
};

EdgeGhosts edge_ghosts(EdgePlace place) {
    EdgeGhosts made;
    made.inside = edge_sample_at(place.at, place.outward);
    made.inside_2 = edge_sample_at(place.at - place.outward, place.outward);
    made.kind = edge_acts_as(edge_kind_of(place.side), made.inside);
    made.shown_at = place.at;
    EdgeSample shown = made.inside;
    EdgeSample shown_2 = made.inside_2;
    if (made.kind == edge_periodic) {
        bool rows = place.outward.x == 0;
        made.shown_at = int2(rows ? place.at.x : samples.x - 1 - place.at.x, rows ? samples.y - 1 - place.at.y : place.at.y);
        shown = edge_sample_at(made.shown_at, place.outward);
        shown_2 = edge_sample_at(made.shown_at + place.outward, place.outward);
    }
    made.ghost = edge_ghost(made.kind, shown);
    made.ghost_2 = made.ghost;
    if (edge_mirrors(made.kind)) made.ghost_2 = edge_ghost(made.kind, shown_2);
    precise real fall = edge_fall(made.kind, made.inside, made.inside_2);
    precise real bed = made.ghost.bed - fall;
    precise real bed_2 = made.ghost_2.bed - (fall + fall);
    made.ghost.bed = bed;
    made.ghost_2.bed = bed_2;
    return made;
}

// The nearer ghost's load of solid, m: that of the sample it shows, to the bit, of an inflow of this concentration, or none.
real edge_load(EdgeGhosts made, real shown_load, real concentration) {
    precise real inflow = concentration * made.ghost.depth;
    if (made.kind == edge_periodic) return shown_load;
    return made.kind == edge_inflow_kind ? inflow : real(0);
}

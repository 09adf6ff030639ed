// The samples of the map's edges, in the order of what is kept for each. Needs `samples`, columns and rows. C++ compiles
// these lines too (sim/terrain/bed_beyond.cpp).

// A place on the way round the map: the sample inside, the step out of the map, and the side.
struct EdgePlace {
    int2 at;
    int2 outward;
    int side;  // 0 north, 1 south, 2 west, 3 east
};

// Round the map are edge_places() of them: the rows in the north and south, then the columns in the west and east.
int edge_places() { return 2 * (samples.x + samples.y); }

// The first of a side's places.
int edge_first(int side) { return side < 2 ? side * samples.x : 2 * samples.x + (side - 2) * samples.y; }

// The place at a column of the north or south, or at a row of the west or east.
int edge_index(int side, int along) { return edge_first(side) + along; }

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

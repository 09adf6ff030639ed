// How the inflow of an edge spreads along it: as its ground conveys uniform flow, whose level gives the edge's discharge
// (docs/numerics.md, "Edges of the water"). Lanes sum up in a fixed order, so that every device finds the same bits. Needs
// maths/cube_root.glsl, maths/edge_places.glsl, the numbers of maths/water_numbers.glsl, and
//   real load_bed(int2 at), m
//   real load_manning(int2 at), s/m^(1/3)

const int conveyance_lanes = 256;
const int conveyance_doublings = 40;
const int conveyance_halvings = 24;
// Depth that the search begins at, m; and ground smoother than this conveys as much as glass does.
const real conveyance_start = real(1e-3);
const real conveyance_smoothest = real(0.01);

// Places of a side.
int conveyance_count(int side) { return side < 2 ? samples.x : samples.y; }

// Of a metre's width, by Manning's law, over the root of the slope, m²/s.
real conveyance_of(real depth, real manning) {
    real h = max(depth, real(0));
    precise real conveyance = ((h * h) * inverse_cube_root(max(h, real(1e-9)))) / max(manning, conveyance_smoothest);
    return conveyance;
}

// Of a place where the water stands so high above the edge's lowest ground.
real conveyance_at(int place, real lowest, real level) {
    int2 at = edge_place(place).at;
    precise real depth = level - (load_bed(at) - lowest);
    return conveyance_of(depth, load_manning(at));
}

// The lowest ground of a lane's places.
real conveyance_lowest(int side, int lane) {
    real lowest = real(3e38);
    for (int i = lane; i < conveyance_count(side); i += conveyance_lanes)
        lowest = min(lowest, load_bed(edge_place(edge_index(side, i)).at));
    return lowest;
}

// The conveyance of a lane's places together: in pairs from both ends, so that a turned edge gives the same bits.
real conveyance_sum(int side, int lane, real lowest, real level) {
    real sum = real(0);
    for (int i = lane; 2 * i < conveyance_count(side); i += conveyance_lanes) {
        int other = conveyance_count(side) - 1 - i;
        real one = conveyance_at(edge_index(side, i), lowest, level);
        real two = other == i ? real(0) : conveyance_at(edge_index(side, other), lowest, level);
        precise real next = sum + (one + two);
        sum = next;
    }
    return sum;
}

// The fastest wave of what comes in at that level, as a bound: the flow is at most critical, m/s.
real conveyance_speed(real level) {
    precise real square = water_gravity * level;
    precise real celerity = sqrt(square);
    return celerity + celerity;
}

// The search for the level above the lowest ground: first doubled until it gives the discharge, then halved.
struct ConveyanceSearch {
    real low;
    real high;
    real level;  // that is looked at
    bool doubles;   // until a level gave it
};

ConveyanceSearch conveyance_search() {
    ConveyanceSearch search;
    search.low = real(0);
    search.high = conveyance_start;
    search.level = conveyance_start;
    search.doubles = true;
    return search;
}

// After the sum of all lanes at its level.
ConveyanceSearch conveyance_next(ConveyanceSearch search, int side, real sum) {
    ConveyanceSearch next = search;
    precise real discharge = (sum * inflow_root_slope) / real(conveyance_count(side));
    bool gives = discharge >= inflow_tick_mean;
    if (search.doubles && !gives) {
        next.low = search.level;
        precise real doubled = search.level + search.level;
        next.high = doubled;
        next.level = doubled;
        return next;
    }
    if (!search.doubles && !gives) next.low = search.level;
    if (gives) next.high = search.level;
    next.doubles = false;
    precise real middle = real(0.5) * (next.low + next.high);
    next.level = middle;
    return next;
}

// What a place takes of the inflow, against what it took if that were spread evenly.
real conveyance_share(int side, int place, real lowest, real level, real sum) {
    precise real share = (conveyance_at(place, lowest, level) * real(conveyance_count(side))) / sum;
    return share;
}

// The kind of a side of the map (maths/edge_places.glsl). Needs the numbers of maths/water_numbers.glsl.
int edge_kind_of(int side) {
    return side < 2 ? (side == 0 ? edge_kind_north : edge_kind_south) : (side == 2 ? edge_kind_west : edge_kind_east);
}

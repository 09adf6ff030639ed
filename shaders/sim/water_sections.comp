// The water that passes the faces of sections in a stage, booked in double: what the stage moves over them, draining limit and
// all. After the tick's time is over it books nothing.
layout(local_size_x = 64) in;
#include "sim/tile_samples.glsl"
#include "sim/water_images.glsl"

layout(rgba32f) uniform readonly image2D water_in;
layout(r32f) uniform readonly image2D bed_in;
layout(std430) readonly buffer SectionFaces { ivec4 section_faces[]; };  // column, row, 1: between rows
layout(std430) buffer SectionBook { double section_book[]; };            // m² east or north over each face

uniform int face_count;

const int water_order = ORDER;
real2 water_share = real2(clock_share_x, clock_share_y);
real water_drain = clock_drain;
const real water_friction = real(0);
#include "sim/cube_root_seed.glsl"
#include "maths/water.glsl"
#include "sim/water_faces.glsl"
#include "maths/edge_kinds.glsl"
#include "maths/water_given_face.glsl"
#include "maths/edge_places.glsl"
#include "sim/water_inflow.glsl"

// Between a row and that south of it: northwards.
real discharge_between_rows(int2 north) {
    real4 ignored;
    WaterCell south_2 = load_cell(north + int2(0, 2), ignored);
    WaterCell south = load_cell(north + int2(0, 1), ignored);
    WaterCell cell = load_cell(north, ignored);
    WaterCell north_2 = load_cell(north + int2(0, -1), ignored);
    WaterFace face =
        face_between(south_2, south, water_slope(south_2, south, cell), cell, water_slope(south, cell, north_2), north_2);
    face = water_given_face(face, north.y == -1, edge_kind_north, -inflow_at(edge_index(0, north.x)));
    return water_given_face(face, north.y == samples.y - 1, edge_kind_south, inflow_at(edge_index(1, north.x))).mass;
}

// Between a column and that west of it: eastwards.
real discharge_between_columns(int2 east) {
    WaterCell west_2 = load_turned(east + int2(-2, 0));
    WaterCell west = load_turned(east + int2(-1, 0));
    WaterCell cell = load_turned(east);
    WaterCell east_2 = load_turned(east + int2(1, 0));
    WaterFace face = face_between(west_2, west, water_slope(west_2, west, cell), cell, water_slope(west, cell, east_2), east_2);
    face = water_given_face(face, east.x == 0, edge_kind_west, inflow_at(edge_index(2, east.y)));
    return water_given_face(face, east.x == samples.x, edge_kind_east, -inflow_at(edge_index(3, east.y))).mass;
}

void main() {
    int index = int(gl_GlobalInvocationID.x);
    if (index >= face_count || clock_dt_s <= real(0)) return;
    ivec4 face = section_faces[index];
    real mass = face.z == 1 ? discharge_between_rows(face.xy) : discharge_between_columns(face.xy);
    double weight = ORDER == 2 ? 0.5lf : 1.0lf;
    section_book[index] += weight * double(mass) * double(clock_dt_s);
}

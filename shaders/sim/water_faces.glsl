// Samples and faces as the stages of the water see them. Needs maths/water.glsl, and the images water_in and bed_in.

// A sample seen along y: `along` is north.
WaterCell load_cell(int2 at, out real4 water) {
    water = imageLoad(water_in, at + water_ghosts);
    real bed = imageLoad(bed_in, at + water_ghosts).x;
    return water_cell(water, bed, water_velocity(water.x, real2(water.w, water.z)));
}

WaterCell load_turned(int2 at) {
    real4 water;
    return water_turned(load_cell(at, water));
}

WaterFace face_between(WaterCell before, WaterCell a, WaterSlope slope_a, WaterCell b, WaterSlope slope_b, WaterCell behind) {
    return water_face(a, slope_a, b, slope_b, water_face_rests(before, a, b, behind));
}

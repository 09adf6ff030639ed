// Stands for the ground beyond the map's edge where it is not known, m. C++ compiles this line too
// (sim/terrain/bed_beyond.h).
const float unknown_bed = -1e30f;

// Bins of the values of a view, 16 between a value and twice that. C++ compiles these lines too (render/view_range.h).
const int range_shift = 19;        // of a float's bits: its exponent and 4 more bits are left
const int range_bins = 1 << 12;
const int range_side = 4;          // a thread counts so many samples in each direction

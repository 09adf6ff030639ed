// What a dab does, how it fades, and what noise and stamps it has. C++ compiles these lines too (sim/passes/dab.h).
const int brush_mode_raise = 0;
const int brush_mode_lower = 1;
const int brush_mode_smooth = 2;
const int brush_mode_flatten = 3;
const int brush_mode_ramp = 4;
const int brush_mode_noise = 5;
const int brush_mode_terrace = 6;
const int brush_mode_stamp = 7;
const int brush_mode_erode = 8;
const int brush_mode_path = 9;

const int falloff_smooth = 0;  // by a cubic
const int falloff_linear = 1;
const int falloff_round = 2;  // like a ball
const int falloff_sharp = 3;  // like a thorn

const int noise_fbm = 0;
const int noise_ridged = 1;
const int noise_billow = 2;

const int stamp_add = 0;
const int stamp_higher = 1;  // lifts what is lower
const int stamp_lower = 2;  // lowers what is higher
const int stamp_replace = 3;

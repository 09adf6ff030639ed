// Blocks of the method uniform: so many patches in a row and a column. C++ compiles these lines too (render/methods/envelope.h).
const int envelope_level = 3;
const int envelope_patches = 1 << envelope_level;

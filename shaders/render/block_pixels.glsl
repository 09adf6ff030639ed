// Blocks of the picture, and lists of them to draw. C++ compiles these lines too (render/blocks.h).

// Pixels of a block in a row and a column.
const int block_pixels = 32;
// A square of so many blocks in a row and a column may be drawn at once: its number among such squares, with this bit.
const int large_block = 4;
const uint large_bit = 0x80000000u;
// Words of an indirect draw.
const int draw_words = 4;

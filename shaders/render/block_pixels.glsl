// Pixels of a block in a row and a column (render/blocks.h).
const int block_pixels = 32;
// A square of so many blocks in a row and a column may be drawn at once: its number among such squares, with this bit.
const int large_block = 4;
const uint large_bit = 0x80000000u;

// C++ compiles this line too (render/methods/beams.cpp).
// Rays of so many pixels in a row and a column go as one beam at first.
const int beam_pixels = 8;

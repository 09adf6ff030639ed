// Parts of the circle around the eye. C++ compiles this line too (render/methods/hybrid.cpp).
const int sector_count = 1024;

// The Courant number of a sub-step of the water. C++ compiles this line too (sim/passes/erode_brush.cpp).
const real water_courant = real(0.5);

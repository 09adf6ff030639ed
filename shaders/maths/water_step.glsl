// The length of the next sub-step. Needs cell_m, real2, metres.

// Courant number by the sum over both axes, dt (s/dx + s/dy); on squares 0.25 of each.
#include "maths/courant.glsl"

real water_inverse_cells() {
    precise real sum = real(1) / cell_m.x + real(1) / cell_m.y;
    return sum;
}

// (sub-step, time left after it), seconds: equal parts of the time left, none longer than the fastest wave allows; in a
// million parts at most, so that every tick ends.
real2 water_substep(real time_left_s, real speed, real courant) {
    precise real parts = (time_left_s * (speed * water_inverse_cells())) / courant;
    real count = min(max(-floor(-parts), real(1)), real(1048576));
    precise real dt = time_left_s / count;
    precise real left = time_left_s - dt;
    return real2(dt, count > real(1) ? left : real(0));
}

// What a face may take of its side's depth, m/s: faces share it by the lengths of the cell, less a rounding.
real water_draining(real dt) {
    precise real drain = real(0.4999) / (dt * water_inverse_cells());
    return drain;
}

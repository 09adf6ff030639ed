// The length of the next sub-step, and what its tables say of it. Needs maths/two_sum.glsl, the numbers of
// maths/water_numbers.glsl, and
//   real load_tick_series(int), as maths/tick_series_values.glsl says
#include "maths/tick_series_values.glsl"

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

// Draining limit, m/s: a face takes at most this times the depth on its side. 0.4999 instead of 0.5 allows for rounding.
real water_draining(real dt) {
    precise real drain = real(0.4999) / (dt * water_inverse_cells());
    return drain;
}

// What holds for one sub-step: its Euler steps follow each other in equal parts of it (maths/water_stage.glsl).
struct WaterSubstep {
    real dt;        // of an Euler step, s
    real left;      // of the tick after the sub-step, s
    real2 share;    // dt / spacing, s/m
    real drain;     // m/s
    real friction;  // dt * gravity * Manning's n²
    real at;        // share of the tick that is past, before the sub-step
    real part;      // share of the tick that an Euler step takes
    real rain;      // mean over the sub-step, m/s
    real inflow;    // mean over the sub-step, m²/s into the map at inflow edges
};

// `speed`: the fastest wave, m/s.
WaterSubstep water_next_substep(real time_left_s, real speed) {
    real2 span = water_substep(time_left_s, speed, water_courant * real(water_eulers));
    precise real dt = span.x / real(water_eulers);
    precise real share_x = dt / cell_m.x;
    precise real share_y = dt / cell_m.y;
    precise real dt_friction = dt * water_roughness;
    precise real at = real(1) - time_left_s / tick_s;
    precise real part = dt / tick_s;
    // As the next sub-step finds its `at`.
    precise real end = real(1) - span.y / tick_s;
    real rain = tick_series_mean(series_rain, at, end);
    real inflow = tick_series_mean(series_inflow, at, end);
    WaterSubstep next;
    next.dt = dt;
    next.left = span.y;
    next.share = real2(share_x, share_y);
    next.drain = water_draining(dt);
    next.friction = dt_friction;
    next.at = at;
    next.part = part;
    next.rain = max(rain, real(0));
    next.inflow = max(inflow, real(0));
    return next;
}

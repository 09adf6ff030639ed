// One dab of a brush on one sample. The including side gives real4 load_solid(int2), repeating the edge, real
// load_stamp(int2), repeating the edge, what maths/brush_weight.glsl and maths/brush_noise.glsl need, and
//   load_path as maths/path.glsl says
//   samples   int2, columns and rows of the terrain
//   dab_mode  int, of maths/brush_modes.glsl, which the including side includes
// and the numbers of maths/dab_numbers.glsl.
#include "maths/brush_noise.glsl"
#include "maths/brush_weight.glsl"
#include "maths/solid.glsl"
#include "maths/path.glsl"

real rise_to_target(real4 c) { return rise(c, real4(dab_target_m.x, dab_target_m.y, real(0), real(0))); }

real noise_at(int2 at) {
    // From the south-west sample: the same at every number of samples.
    precise real x = real(at.x) * cell_m.x / noise_wavelength_m;
    precise real y = real(samples.y - 1 - at.y) * cell_m.y / noise_wavelength_m;
    return brush_noise(real2(x, y));
}

// How much higher the ground's terrace is, `below` metres under a step's edge.
real terrace_rise(real below) {
    precise real steps = -below / terrace_step_m;
    precise real within = steps - floor(steps);
    precise real s = min(max((within - terrace_flat) / max(real(1) - terrace_flat, real(1e-6)), real(0)), real(1));
    precise real change = (s * s * (real(3) - real(2) * s) - within) * terrace_step_m;
    return change;
}

// The stamp there, bilinear between its samples; beyond it -1.
real stamp_at(real2 offset_m) {
    precise real x = offset_m.x * stamp_columns.x + offset_m.y * stamp_columns.y;
    precise real y = offset_m.x * stamp_rows.x + offset_m.y * stamp_rows.y;
    precise real column = x + real(stamp_samples.x - 1) * real(0.5);
    precise real row = y + real(stamp_samples.y - 1) * real(0.5);
    // Roundings of an edge that lies on samples are none beyond it.
    real slack = real(1e-3);
    if (column < -slack || row < -slack || column > real(stamp_samples.x - 1) + slack ||
        row > real(stamp_samples.y - 1) + slack)
        return real(-1);
    precise real c = min(max(column, real(0)), real(stamp_samples.x - 1));
    precise real r = min(max(row, real(0)), real(stamp_samples.y - 1));
    int2 cell = int2(int(floor(c)), int(floor(r)));
    precise real u = c - floor(c);
    precise real v = r - floor(r);
    real a = load_stamp(cell);
    real b = load_stamp(cell + int2(1, 0));
    real d = load_stamp(cell + int2(0, 1));
    real e = load_stamp(cell + int2(1, 1));
    precise real top = a + u * (b - a);
    precise real bottom = d + u * (e - d);
    precise real value = top + v * (bottom - top);
    return value;
}

real stamp_change(real4 c, real2 offset_m) {
    real stamp = stamp_at(offset_m);
    if (stamp < real(0)) return real(0);
    precise real height_m = (stamp - stamp_zero) * dab_amount_m;
    if (stamp_mode == stamp_add) return height_m * dab_blend;
    precise real to_stamp = rise_to_target(c) + height_m;
    if (stamp_mode == stamp_higher) to_stamp = max(to_stamp, real(0));
    if (stamp_mode == stamp_lower) to_stamp = min(to_stamp, real(0));
    return to_stamp * dab_blend;
}

// Metres that the dab adds to the ground at the sample.
real brush_change(int2 at, real4 c) {
    if (dab_mode == brush_mode_path) {
        precise real shaped = load_mask(at) * path_change(dab_offset_m(at), rise_to_target(c));
        return shaped;
    }
    real weight = brush_weight_at(at);
    if (weight == real(0)) return real(0);
    precise real change = weight * dab_amount_m;
    if (dab_mode == brush_mode_lower) change = -change;
    if (dab_mode == brush_mode_smooth) {
        // Half way to the four neighbours at most, each axis by the inverse square of its spacing: isotropic, stable.
        precise real xx = cell_m.x * cell_m.x;
        precise real yy = cell_m.y * cell_m.y;
        precise real rises_x = rise(c, load_solid(at + int2(1, 0))) + rise(c, load_solid(at + int2(-1, 0)));
        precise real rises_y = rise(c, load_solid(at + int2(0, 1))) + rise(c, load_solid(at + int2(0, -1)));
        precise real mean = (rises_x * yy + rises_y * xx) / (real(2) * (xx + yy));
        change = (weight * dab_blend) * mean;
    }
    if (dab_mode == brush_mode_flatten) change = (weight * dab_blend) * rise_to_target(c);
    if (dab_mode == brush_mode_ramp) {
        precise real to_ramp = rise_to_target(c) + dab_along(dab_offset_m(at)) * ramp_rise_m;
        change = (weight * dab_blend) * to_ramp;
    }
    if (dab_mode == brush_mode_noise) change = change * noise_at(at);
    if (dab_mode == brush_mode_terrace) change = (weight * dab_blend) * terrace_rise(rise_to_target(c));
    if (dab_mode == brush_mode_stamp) change = weight * stamp_change(c, dab_offset_m(at));
    return change;
}

real4 brush_sample(real4 c, real change) { return change_ground(c, change, dab_on_regolith != 0); }

#pragma once
#include "sim/passes/dab.h"

namespace talus {

// The fields of a dab, once: journals, checks and uniforms visit them. `visit` is called with a field's name
// and value and, for a number or a pair of them, its smallest and largest value, for a choice, the names of
// its values.

/// What every dab has but its mode.
template <typename AnyDab, typename Visit>
void visit_footprint(AnyDab& dab, Visit&& visit) {
    const bool digs = dab.mode == BrushMode::noise || dab.mode == BrushMode::stamp;
    // Flatten away from its target exaggerates the relief.
    const bool exaggerates = dab.mode == BrushMode::flatten;
    visit("x_m", dab.x_m, -1e9, 1e9);
    visit("y_m", dab.y_m, -1e9, 1e9);
    visit("radius_m", dab.radius_m, 1e-6, 1e9);
    visit("falloff", dab.falloff, 0, 1);
    visit("amount_m", dab.amount_m, digs ? -1e6 : 0, 1e6);
    visit("blend", dab.blend, exaggerates ? -1000 : 0, 1);
    visit("target_m", dab.target_m, -1e6, 1e6);
    visit("material", dab.material, material_names());
    visit("curve", dab.curve, falloff_curve_names());
    visit("masked", dab.masked);
}

/// What dabs of a mode have besides. Shaders know them by the mode's name and the field's: ramp_rise_m.
template <typename AnyDab, typename Visit>
void visit_own(AnyDab& dab, BrushMode mode, Visit&& visit) {
    switch (mode) {
        case BrushMode::ramp:
            visit("way_m", dab.way_m, -1e9, 1e9);
            visit("rise_m", dab.rise_m, -1e6, 1e6);
            break;
        case BrushMode::terrace:
            visit("step_m", dab.step_m, 1e-3, 1e6);
            visit("flat", dab.flat, 0, 0.99);
            break;
        case BrushMode::noise:
            visit("kind", dab.noise.kind, noise_kind_names());
            visit("wavelength_m", dab.noise.wavelength_m, 1e-3, 1e9);
            visit("octaves", dab.noise.octaves, 1, 16);
            visit("gain", dab.noise.gain, 0, 1);
            visit("warp", dab.noise.warp, 0, 10);
            visit("seed", dab.noise.seed, 0, 4294967295.0);
            break;
        case BrushMode::stamp:
            visit("mode", dab.stamp.mode, stamp_mode_names());
            visit("half_m", dab.stamp.half_m, 1e-6, 1e9);
            visit("turn_deg", dab.stamp.turn_deg, -3600, 3600);
            visit("mirrored", dab.stamp.mirrored);
            visit("zero", dab.stamp.zero, -1e6, 1e6);
            break;
        case BrushMode::erode:
            visit("rain_mm_per_h", dab.erode.rain_mm_per_h, 0, 1e4);
            visit("time_s", dab.erode.time_s, 1e-6, 1e6);
            visit("acceleration", dab.erode.acceleration, 1, 1e5);
            visit("begins", dab.erode.begins);
            visit("ends", dab.erode.ends);
            break;
        default:
            break;
    }
}

}  // namespace talus

#pragma once
#include <vector>

#include "shaders/maths/twin.h"
#include "sim/passes/dab_step.h"

namespace talus::maths {

/// The CPU twin of shaders/sim/brush.comp: one dab over the whole terrain.
template <typename Real>
struct BrushTwin {
    TALUS_TWIN_NAMES(Real)

    int nx = 0;
    int ny = 0;
    real2 cell_m{1};
    int2 dab_sample{0};
    real2 dab_offset{0};
    real dab_radius_m{0};
    real dab_falloff{0};
    int dab_mode = 0;
    real dab_amount_m{0};
    real dab_blend{0};
    real2 dab_target_m{0};
    int dab_on_regolith = 0;
    int dab_curve = 0;
    real2 dab_length_m{0};
    real ramp_rise_m{0};
    int noise_kind = 0;
    int noise_octaves = 1;
    real noise_gain{0};
    real noise_warp{0};
    unsigned noise_seed = 0;
    real noise_wavelength_m{1};
    real terrace_step_m{1};
    real terrace_flat{0};
    int2 stamp_samples{2};
    real2 stamp_columns{0};
    real2 stamp_rows{0};
    real stamp_zero{0};
    int stamp_mode = 0;
    bool masked = false;
    std::vector<real> masks;
    std::vector<real> stamp_heights;
    int2 samples{0};
    std::vector<real4> ground_samples;

    real load_mask(int2 at) const {
        return masked ? masks[static_cast<std::size_t>(at.y) * nx + at.x] : real(1);
    }
    real load_stamp(int2 at) const {
        const int2 inside = glm::clamp(at, int2(0), stamp_samples - 1);
        return stamp_heights[static_cast<std::size_t>(inside.y) * stamp_samples.x + inside.x];
    }

    real4 load_solid(int2 at) const {
        const int x = at.x < 0 ? 0 : (at.x >= nx ? nx - 1 : at.x);
        const int y = at.y < 0 ? 0 : (at.y >= ny ? ny - 1 : at.y);
        return ground_samples[static_cast<std::size_t>(y) * nx + x];
    }

#include "maths/brush_modes.glsl"

#include "maths/brush.glsl"

    void dab(const Dab& dab, const DabStep& step) {
        samples = int2(nx, ny);
        cell_m = real2(step.cell_m);
        dab_sample = step.sample;
        dab_offset = real2(step.offset);
        dab_radius_m = step.radius_m;
        dab_falloff = step.falloff;
        dab_curve = step.curve;
        dab_length_m = real2(step.length_m);
        dab_mode = step.mode;
        dab_amount_m = step.amount_m;
        dab_blend = step.blend;
        dab_target_m = real2(step.target_m);
        ramp_rise_m = step.rise_m;
        dab_on_regolith = step.on_regolith;
        if (const auto* noise = dab.as<NoiseDab>()) {
            noise_kind = noise->kind;
            noise_octaves = noise->octaves;
            noise_gain = static_cast<float>(noise->gain);
            noise_warp = static_cast<float>(noise->warp);
            noise_seed = noise->seed;
            noise_wavelength_m = static_cast<float>(noise->wavelength_m);
        }
        if (const auto* terrace = dab.as<TerraceDab>()) {
            terrace_step_m = static_cast<float>(terrace->step_m);
            terrace_flat = static_cast<float>(terrace->flat);
        }
        if (const auto* stamp = dab.as<StampDab>()) stamp_mode = static_cast<int>(stamp->mode);
        stamp_columns = real2(step.stamp_columns);
        stamp_rows = real2(step.stamp_rows);
        stamp_zero = step.stamp_zero;
        masked = dab.masked;
        std::vector<real4> next = ground_samples;
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x) {
                const std::size_t i = static_cast<std::size_t>(y) * nx + x;
                const real change = brush_change(int2(x, y), ground_samples[i]);
                if (change != real(0)) next[i] = brush_sample(ground_samples[i], change);
            }
        ground_samples.swap(next);
    }
};

}  // namespace talus::maths

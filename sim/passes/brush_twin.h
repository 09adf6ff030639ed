#pragma once
#include <vector>

#include "shaders/maths/twin.h"
#include "sim/passes/brush.h"

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
    std::vector<real4> samples;

    real4 load_solid(int2 at) const {
        const int x = at.x < 0 ? 0 : (at.x >= nx ? nx - 1 : at.x);
        const int y = at.y < 0 ? 0 : (at.y >= ny ? ny - 1 : at.y);
        return samples[static_cast<std::size_t>(y) * nx + x];
    }

#include "maths/brush.glsl"

    void dab(const DabStep& step) {
        cell_m = real2(step.cell_m);
        dab_sample = step.sample;
        dab_offset = real2(step.offset);
        dab_radius_m = step.radius_m;
        dab_falloff = step.falloff;
        dab_mode = step.mode;
        dab_amount_m = step.amount_m;
        dab_blend = step.blend;
        dab_target_m = real2(step.target_m);
        dab_on_regolith = step.on_regolith;
        std::vector<real4> next = samples;
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x) {
                const std::size_t i = static_cast<std::size_t>(y) * nx + x;
                const real change = brush_change(int2(x, y), samples[i]);
                if (change != real(0)) next[i] = brush_sample(samples[i], change);
            }
        samples.swap(next);
    }
};

}  // namespace talus::maths

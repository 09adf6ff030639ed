#pragma once
#include <vector>

#include "shaders/maths/twin.h"
#include "sim/passes/dab_numbers.h"

namespace talus::maths {

/// The CPU twin of shaders/sim/brush.comp: one dab over the whole terrain.
template <typename Real>
struct BrushTwin {
    TALUS_TWIN_NAMES(Real)

    int nx = 0;
    int ny = 0;
    int dab_mode = 0;
#define NUMBER TALUS_MEMBER
#include "maths/dab_numbers.glsl"
#undef NUMBER
    std::vector<real> masks;
    std::vector<real> stamp_heights;
    std::vector<glm::vec4> path;  ///< as path_line() (sim/passes/dab_numbers.h)
    int2 samples{0};
    std::vector<real4> ground_samples;
    std::vector<real4> worn;  ///< wear and deposition as in TerrainState; empty: not counted

    real load_mask(int2 at) const {
        return dab_masked != 0 ? masks[static_cast<std::size_t>(at.y) * nx + at.x] : real(1);
    }
    real load_stamp(int2 at) const {
        const int2 inside = glm::clamp(at, int2(0), stamp_samples - 1);
        return stamp_heights[static_cast<std::size_t>(inside.y) * stamp_samples.x + inside.x];
    }

    real3 load_path(int i) const {
        return real3(path[static_cast<std::size_t>(i)]);
    }

    real4 load_solid(int2 at) const {
        const int x = at.x < 0 ? 0 : (at.x >= nx ? nx - 1 : at.x);
        const int y = at.y < 0 ? 0 : (at.y >= ny ? ny - 1 : at.y);
        return ground_samples[static_cast<std::size_t>(y) * nx + x];
    }

#include "maths/brush_modes.glsl"

#include "maths/brush.glsl"

#include "maths/wear.glsl"

    void dab(BrushMode mode, const DabNumbers& numbers) {
        samples = int2(nx, ny);
        dab_mode = static_cast<int>(mode);
#define NUMBER TALUS_TAKE
#include "maths/dab_numbers.glsl"
#undef NUMBER
        std::vector<real4> next = ground_samples;
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x) {
                const std::size_t i = static_cast<std::size_t>(y) * nx + x;
                const real change = brush_change(int2(x, y), ground_samples[i]);
                if (change != real(0)) next[i] = brush_sample(ground_samples[i], change);
            }
        for (std::size_t i = 0; i < worn.size(); ++i)
            worn[i] = wear_counted(worn[i], ground_samples[i], next[i]);
        ground_samples.swap(next);
    }
};

}  // namespace talus::maths

#pragma once
#include <vector>

#include "shaders/maths/twin.h"
#include "sim/passes/thermal_step.h"

namespace talus::maths {

/// The CPU twin of shaders/sim/thermal.comp: one sub-step over the whole terrain. In float it agrees
/// bit for bit with a device that rounds as IEEE 754 asks, as llvmpipe does; in double it says what float
/// costs. Samples are (bedrock high, low, regolith high, low), metres.
template <typename Real>
struct ThermalTwin {
    TALUS_TWIN_NAMES(Real)

    int nx = 0;
    int ny = 0;
#define NUMBER TALUS_MEMBER
#include "maths/thermal_numbers.glsl"
#undef NUMBER
    std::vector<real4> samples;
    std::vector<bool> wet;    ///< samples under water; empty: none
    std::vector<Real> masks;  ///< 0 to 1; empty: 1 throughout
    std::vector<real4> worn;  ///< wear and deposition as in TerrainState; empty: not counted

    ThermalScheme scheme;
    bool only_lowest;

    ThermalTwin(const Grid& grid, const ThermalStep& step)
        : nx(grid.nx),
          ny(grid.ny),
          scheme(step.scheme),
          only_lowest(step.scheme == ThermalScheme::olsen_fast) {
        take(step.numbers);
    }

    real load_mask(int2 at) const {
        if (masks.empty()) return real(1);
        const int x = at.x < 0 ? 0 : (at.x >= nx ? nx - 1 : at.x);
        const int y = at.y < 0 ? 0 : (at.y >= ny ? ny - 1 : at.y);
        return masks[static_cast<std::size_t>(y) * nx + x];
    }

    real load_repose(int2 at) const {
        if (wet.empty() || at.x < 0 || at.y < 0 || at.x >= nx || at.y >= ny) return repose_slope;
        return wet[static_cast<std::size_t>(at.y) * nx + at.x] ? wet_slope : repose_slope;
    }

    real4 load_solid(int2 at) const {
        const int x = at.x < 0 ? 0 : (at.x >= nx ? nx - 1 : at.x);
        const int y = at.y < 0 ? 0 : (at.y >= ny ? ny - 1 : at.y);
        return samples[static_cast<std::size_t>(y) * nx + x];
    }

    bool is_sample(int2 at) const {
        return at.x >= 0 && at.y >= 0 && at.x < nx && at.y < ny;
    }

#include "maths/thermal.glsl"

#include "maths/olsen.glsl"

#include "maths/wear.glsl"

    void step() {
        std::vector<real4> next(samples.size());
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x)
                next[static_cast<std::size_t>(y) * nx + x] =
                    scheme == ThermalScheme::gradient ? thermal_sample(int2(x, y)) : olsen_sample(int2(x, y));
        for (std::size_t i = 0; i < worn.size(); ++i) worn[i] = wear_counted(worn[i], samples[i], next[i]);
        samples.swap(next);
    }

    void take(const ThermalNumbers& numbers) {
#define NUMBER TALUS_TAKE
#include "maths/thermal_numbers.glsl"
#undef NUMBER
    }
};

}  // namespace talus::maths

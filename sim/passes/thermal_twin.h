#pragma once
#include <vector>

#include "shaders/maths/twin.h"
#include "sim/passes/thermal.h"
#include "sim/terrain/grid.h"

namespace talus::maths {

/// The CPU twin of shaders/sim/thermal.comp: one sub-step over the whole terrain. In float it agrees
/// bit for bit with a device that rounds as IEEE 754 asks, as llvmpipe does; in double it says what float
/// costs. Samples are (bedrock high, low, regolith high, low), metres.
template <typename Real>
struct ThermalTwin {
    TALUS_TWIN_NAMES(Real)

    int nx = 0;
    int ny = 0;
    real2 cell_m{1};
    real repose_slope{1};
    real wet_slope{1};
    real bedrock_slope{1};
    real2 face_share{0};
    real thermal_bulking{1};
    real weathering{0};
    std::vector<real4> samples;
    std::vector<bool> wet;    ///< samples under water; empty: none
    std::vector<Real> masks;  ///< 0 to 1; empty: 1 throughout

    ThermalTwin(const Grid& grid, const ThermalStep& step)
        : nx(grid.nx),
          ny(grid.ny),
          cell_m(step.cell_m),
          repose_slope(step.repose_slope),
          wet_slope(step.wet_slope),
          bedrock_slope(step.bedrock_slope),
          face_share(step.face_share),
          thermal_bulking(step.bulking),
          weathering(step.weathering_m) {}

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

#include "maths/thermal.glsl"

    void step() {
        std::vector<real4> next(samples.size());
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x)
                next[static_cast<std::size_t>(y) * nx + x] = thermal_sample(int2(x, y));
        samples.swap(next);
    }
};

}  // namespace talus::maths

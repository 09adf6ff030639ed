#pragma once
#include "shaders/maths/twin.h"
#include "sim/passes/thermal_settings.h"
#include "sim/terrain/grid.h"

namespace talus {

/// What shaders are told of a sub-step of thermal erosion; the twin takes the same numbers.
struct ThermalNumbers {
    TALUS_TWIN_NAMES(float)
#define NUMBER TALUS_MEMBER
#include "maths/thermal_numbers.glsl"
#undef NUMBER
};

struct ThermalStep {
    bool masked = false;       ///< slopes slide as far as the mask says
    bool counts_wear = false;  ///< where the terrain has the layer
    ThermalScheme scheme = ThermalScheme::gradient;
    ThermalNumbers numbers;
};

/// Sub-steps that a span of time needs: rate * dt * (1/dx² + 1/dy²) <= (1 - porosity)/2 in each
/// (docs/numerics.md); Olsen's steps have no rate, and are one a span. Throws talus::Error when there would
/// be more than 10,000.
int thermal_substeps(const Grid& grid, const ThermalSettings& settings, double span_s);

/// One of `substeps` equal parts of the span.
ThermalStep thermal_step(const Grid& grid, const ThermalSettings& settings, double span_s, int substeps);

/// The largest rate (m²/s) whose tick is a single sub-step at four fifths of the stable length.
double natural_thermal_rate(const Grid& grid, double span_s, double porosity = 0);

}  // namespace talus

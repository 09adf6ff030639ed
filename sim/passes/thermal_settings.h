#pragma once
#include <vector>

#include "sim/parameter_binding.h"

namespace talus {

/// Which laws slopes slide by.
enum class ThermalScheme {
    gradient,   ///< along the full gradient (shaders/maths/thermal.glsl)
    olsen,      ///< Olsen 2004: by drops to eight neighbours (shaders/maths/olsen.glsl), to compare with
    olsen_fast  ///< his faster variant: to the lowest of the four diagonal ones
};

/// Thermal erosion settings with units. Its values are the defaults of the parameters that set them.
struct ThermalSettings {
    double repose_deg = 33;
    double rate_m2_per_s = 0;
    double wet_deg = repose_deg;      ///< angle of repose of regolith under water
    double bedrock_deg = repose_deg;  ///< angle that bedrock fails at
    double porosity = 0;              ///< of regolith
    double weathering_m_per_s = 0;    ///< bare bedrock that turns into regolith
    bool masked = false;              ///< as far as the mask says
    ThermalScheme scheme = ThermalScheme::gradient;
    bool operator==(const ThermalSettings&) const = default;
};

const std::vector<BoundParameter<ThermalSettings>>& thermal_parameters();
ThermalSettings thermal_settings(const Parameters& parameters);

}  // namespace talus

#include "sim/passes/thermal_settings.h"

namespace talus {

const std::vector<BoundParameter<ThermalSettings>>& thermal_parameters() {
    constexpr double mm_per_h = 1e-3 / 3600;
    static const ThermalSettings preset;
    static const std::vector<BoundParameter<ThermalSettings>> table = {
        unbound<ThermalSettings>(
            toggle("thermal.on", true, "Thermal erosion: what is steeper than its angle of repose slides.")
                .labelled("Slopes slide")),
        bound(choice("thermal.scheme", "gradient", {"gradient", "olsen", "olsen_fast"},
                     "How slopes slide: along the gradient; or, to compare, as Olsen 2004 has it, to single "
                     "neighbours, one step a tick, at the angle of repose alone. The tool erode takes the "
                     "gradient.")
                  .labelled("Scheme")
                  .choices_labelled({"Along the gradient", "Olsen 2004", "Olsen 2004, fast"}),
              &ThermalSettings::scheme),
        bound(number("thermal.repose_deg", preset.repose_deg, 1, 80, "°",
                     "Angle of repose: the steepest slope at which loose ground rests.")
                  .labelled("Angle of repose"),
              &ThermalSettings::repose_deg),
        bound(number("thermal.rate_m2_per_s", preset.rate_m2_per_s, 0, 1e12, "m²/s",
                     "How fast steep ground slides. Unless set, it follows the spacing: one sub-step a tick.")
                  .labelled("Speed of sliding"),
              &ThermalSettings::rate_m2_per_s),
        bound(number("thermal.bedrock_deg", preset.bedrock_deg, 1, 89, "°",
                     "Angle that bedrock fails at. Unless set, it slides at the angle of repose, like scree.")
                  .labelled("Bedrock fails at")
                  .following("thermal.repose_deg"),
              &ThermalSettings::bedrock_deg),
        bound(number("thermal.wet_deg", preset.wet_deg, 1, 80, "°",
                     "Angle of repose of regolith under water. Unless set, the same as in the dry.")
                  .labelled("Angle under water")
                  .following("thermal.repose_deg"),
              &ThermalSettings::wet_deg),
        bound(number("thermal.weathering_mm_per_h", preset.weathering_m_per_s / mm_per_h, 0, 1e6, "mm/h",
                     "How fast bare bedrock turns into regolith; half a metre of regolith halves it.")
                  .once("thermal.weathering"),
              &ThermalSettings::weathering_m_per_s, mm_per_h),
        shared("erosion.porosity", &ThermalSettings::porosity),
        shared("erosion.over", &ThermalSettings::masked)};
    return table;
}

ThermalSettings thermal_settings(const Parameters& parameters) {
    return bound_settings(thermal_parameters(), parameters);
}

}  // namespace talus

#include "sim/passes/sediment_step.h"

namespace talus {

float bulking_of(double porosity) {
    return static_cast<float>(1 / (1 - porosity));
}

SedimentNumbers sediment_numbers(const WaterSettings& water) {
    constexpr double water_kg_per_m3 = 1000;
    const SedimentSettings& settings = water.sediment;
    const double manning = water.manning_s_per_m13;
    SedimentNumbers numbers;
    numbers.sediment_drag = static_cast<float>(water_kg_per_m3 * water.gravity_m_per_s2 * manning * manning);
    numbers.sediment_critical = static_cast<float>(settings.critical_pa);
    numbers.sediment_regolith = static_cast<float>(settings.regolith_m_per_s_pa);
    numbers.sediment_bedrock = static_cast<float>(settings.bedrock_m_per_s_pa);
    numbers.sediment_settling = static_cast<float>(settings.settling_m_per_s);
    numbers.sediment_speedup = static_cast<float>(settings.acceleration);
    numbers.sediment_bulking = bulking_of(settings.porosity);
    numbers.sediment_per_rock = 1 / numbers.sediment_speedup;
    numbers.sediment_per_loose = 1 / (numbers.sediment_speedup * numbers.sediment_bulking);
    numbers.sediment_inflow = static_cast<float>(settings.inflow_concentration);
    numbers.sediment_masked = settings.masked ? 1 : 0;
    numbers.sediment_below = settings.below_neighbours ? 1 : 0;
    numbers.sediment_strata = glm::vec2(settings.strata_m, settings.strata_hardness);
    return numbers;
}

}  // namespace talus

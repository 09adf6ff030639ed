#include "sim/pass_settings.h"

#include <array>

namespace talus {
namespace {

constexpr double m_per_s = 1e-3 / 3600;  // a mm/h

SedimentSettings sediment_settings(const Parameters& parameters) {
    constexpr double m3_per_n_s = 1e-6;
    SedimentSettings settings;
    // Off, nothing new is taken; what is on its way settles.
    const double taking = parameters.toggle("erosion.on") ? m3_per_n_s : 0;
    settings.regolith_m_per_s_pa = parameters.number("erosion.erodibility") * taking;
    settings.bedrock_m_per_s_pa = parameters.number("erosion.bedrock_erodibility") * taking;
    settings.critical_pa = parameters.number("erosion.critical_shear");
    settings.settling_m_per_s = parameters.number("erosion.settling") * 1e-3;
    settings.porosity = parameters.number("erosion.porosity");
    settings.acceleration = parameters.number("erosion.acceleration");
    settings.inflow_concentration =
        parameters.toggle("erosion.on") ? parameters.number("erosion.inflow_concentration") : 0;
    settings.masked = parameters.choice("erosion.over") == "mask";
    settings.strata_m = parameters.number("erosion.strata_m");
    settings.strata_hardness = parameters.number("erosion.strata_hardness");
    return settings;
}

}  // namespace

ThermalSettings thermal_settings(const Parameters& parameters) {
    ThermalSettings settings;
    settings.repose_deg = parameters.number("thermal.repose_deg");
    settings.rate_m2_per_s = parameters.number("thermal.rate_m2_per_s");
    const auto angle = [&](const char* name) {
        return parameters.is_given(name) ? parameters.number(name) : settings.repose_deg;
    };
    settings.wet_deg = angle("thermal.wet_deg");
    settings.bedrock_deg = angle("thermal.bedrock_deg");
    settings.porosity = parameters.number("erosion.porosity");
    settings.masked = parameters.choice("erosion.over") == "mask";
    settings.weathering_m_per_s = parameters.number("thermal.weathering") * m_per_s;
    return settings;
}

void follow_repose(Parameters& parameters) {
    for (const char* name : {"thermal.bedrock_deg", "thermal.wet_deg"})
        parameters.suggest(name, parameters.number("thermal.repose_deg"));
}

// As the shaders count them, so that their roundings are not taken for solid.
SolidWeights weights_of(const Parameters& parameters) {
    return {1 / static_cast<double>(bulking_of(parameters.number("erosion.porosity"))),
            static_cast<double>(static_cast<float>(parameters.number("erosion.acceleration")))};
}

WaterSettings water_settings_of(const Parameters& parameters) {
    WaterSettings settings;
    settings.order = parameters.whole("water.order");
    settings.gravity_m_per_s2 = parameters.number("water.gravity");
    settings.manning_s_per_m13 = parameters.number("water.manning");
    settings.rain_m_per_s = parameters.number("water.rain") * m_per_s;
    settings.rain_masked = parameters.choice("water.rain_over") == "mask";
    settings.infiltration_m_per_s = parameters.number("water.infiltration") * m_per_s;
    settings.evaporation_m_per_s = parameters.number("water.evaporation") * m_per_s;
    const std::array<const char*, 4> edges = {"north", "south", "west", "east"};
    for (std::size_t edge = 0; edge < 4; ++edge)
        settings.edges[edge] = parameters.choice_as<EdgeKind>(std::string("water.boundary.") + edges[edge]);
    // Either of two opposite edges joins them.
    for (const std::size_t edge : {0U, 2U})
        if (settings.edges[edge] == EdgeKind::periodic || settings.edges[edge + 1] == EdgeKind::periodic)
            settings.edges[edge] = settings.edges[edge + 1] = EdgeKind::periodic;
    settings.level_m = parameters.number("water.sea_level");
    settings.inflow_m3_per_s = parameters.number("water.inflow");
    settings.inflow_rise_s = parameters.number("water.inflow_rise");
    settings.inflow_fall_s = parameters.number("water.inflow_fall");
    settings.wave_form = parameters.choice("water.wave") == "sine" ? WaveForm::sine : WaveForm::solitary;
    settings.wave_height_m = parameters.number("water.wave_height");
    settings.wave_period_s = parameters.number("water.wave_period");
    settings.wave_depth_m = parameters.number("water.wave_depth");
    settings.sediment = sediment_settings(parameters);
    return settings;
}

bool drives_edges(const std::string& name) {
    return name.starts_with("water.boundary.") || name.starts_with("water.wave") ||
           name.starts_with("water.inflow");
}

}  // namespace talus

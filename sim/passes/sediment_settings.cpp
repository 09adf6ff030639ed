#include "sim/passes/sediment_settings.h"

namespace talus {

const std::vector<BoundParameter<SedimentSettings>>& sediment_parameters() {
    constexpr double cm3_per_n_s = 1e-6;
    constexpr double mm_per_s = 1e-3;
    static const SedimentSettings preset;
    static const std::vector<BoundParameter<SedimentSettings>> table = {
        unbound<SedimentSettings>(toggle("erosion.on", false,
                                         "Running water takes solid from its bed, carries it, and lets it "
                                         "settle where it slackens. Off: "
                                         "what is on its way still settles.")
                                      .labelled("Water erodes")),
        bound(choice(
                  "erosion.over", preset.masked, {"everywhere", "mask"},
                  "Where water takes solid and slopes slide; by the mask: as far as it says, so that a brush "
                  "erodes here and nowhere else.")
                  .labelled("Erode where"),
              &SedimentSettings::masked),
        bound(number("erosion.erodibility", preset.regolith_m_per_s_pa / cm3_per_n_s, 0, 1e6, "cm³/(N s)",
                     "Of regolith: a pascal above the critical stress takes so many millionths of a metre a "
                     "second. "
                     "0.01 stiff clay, 1 to 100 loose ground (Hanson & Simon 2001).")
                  .labelled("Erodibility, loose"),
              &SedimentSettings::regolith_m_per_s_pa, cm3_per_n_s),
        bound(number("erosion.bedrock_erodibility", preset.bedrock_m_per_s_pa / cm3_per_n_s, 0, 1e6,
                     "cm³/(N s)", "Of bedrock.")
                  .labelled("Erodibility, rock"),
              &SedimentSettings::bedrock_m_per_s_pa, cm3_per_n_s),
        bound(number("erosion.critical_shear_pa", preset.critical_pa, 0, 1e6, "Pa",
                     "Shear stress of the water on its bed that takes nothing yet. The stress follows "
                     "water.manning: "
                     "where that is 0, nothing erodes.")
                  .labelled("Critical shear")
                  .once("erosion.critical_shear"),
              &SedimentSettings::critical_pa),
        bound(number("erosion.settling_mm_per_s", preset.settling_m_per_s / mm_per_s, 0, 1e4, "mm/s",
                     "How fast grains settle in still water: 0.01 silt, 10 fine sand, 100 gravel.")
                  .labelled("Settling speed")
                  .once("erosion.settling"),
              &SedimentSettings::settling_m_per_s, mm_per_s),
        bound(number("erosion.porosity", preset.porosity, 0, 0.9, "",
                     "Share of voids in regolith: in what settles and in scree. 0.3 to 0.4 in sand.")
                  .setting_off(SetsOff::solid_weights)
                  .following_tables(Driven::never),
              &SedimentSettings::porosity),
        bound(
            number("erosion.acceleration", preset.acceleration, 1, 1000, "",
                   "How often each exchange counts for the ground: geology waits for no water (morphological "
                   "factor).")
                .labelled("Acceleration")
                .setting_off(SetsOff::solid_weights)
                .following_tables(Driven::never),
            &SedimentSettings::acceleration),
        bound(number("erosion.inflow_concentration", preset.inflow_concentration, 0, 0.3, "",
                     "Solid in the water that enters by edges of kind inflow, by volume.")
                  .labelled("Solid in the inflow"),
              &SedimentSettings::inflow_concentration),
        bound(number("erosion.strata_m", preset.strata_m, 0, 1e5, "m",
                     "Bedrock in level layers: thickness of a hard and a soft one together; 0: none.")
                  .labelled("Strata, thickness"),
              &SedimentSettings::strata_m),
        bound(number("erosion.strata_hardness", preset.strata_hardness, 0, 1, "",
                     "Hardness of the hard ones; 1 does not erode.")
                  .labelled("Strata, hardness"),
              &SedimentSettings::strata_hardness)};
    return table;
}

SedimentSettings sediment_settings(const Parameters& parameters) {
    SedimentSettings settings = bound_settings(sediment_parameters(), parameters);
    if (!parameters.toggle("erosion.on"))
        settings.regolith_m_per_s_pa = settings.bedrock_m_per_s_pa = settings.inflow_concentration = 0;
    return settings;
}

}  // namespace talus

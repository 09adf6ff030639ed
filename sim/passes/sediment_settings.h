#pragma once
#include <vector>

#include "sim/parameter_binding.h"

namespace talus {

/// Settings of erosion by water, with units (docs/numerics.md, "Sediment"). Its values are the defaults of
/// the parameters that set them.
struct SedimentSettings {
    bool carried = false;  ///< the water has a load: the terrain has a suspended layer
    double regolith_m_per_s_pa =
        1e-6;  ///< erodibility: metres a second for a pascal above the critical stress
    double bedrock_m_per_s_pa = 1e-7;
    double critical_pa = 5;
    double settling_m_per_s = 0.01;
    double porosity = 0;              ///< of what settled
    double acceleration = 1;          ///< how often an exchange counts for the bed
    double inflow_concentration = 0;  ///< by volume, of what enters by edges of kind inflow
    bool masked = false;              ///< water takes as much as the mask says
    bool below_neighbours = false;    ///< what settles raises no sample above its highest neighbour
    double strata_m = 0;              ///< thickness of a pair of bedrock layers; 0: none
    double strata_hardness = 0.9;     ///< of the harder one
    bool operator==(const SedimentSettings&) const = default;
};

const std::vector<BoundParameter<SedimentSettings>>& sediment_parameters();
/// Where erosion is off nothing new is taken; what is on its way settles.
SedimentSettings sediment_settings(const Parameters& parameters);

}  // namespace talus

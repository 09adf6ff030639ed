#pragma once
#include <string>

#include "sim/ledger.h"
#include "sim/parameters.h"
#include "sim/passes/thermal.h"
#include "sim/passes/water.h"

namespace talus {

/// What the passes take from the declared parameters, in their own units.
ThermalSettings thermal_settings(const Parameters& parameters);
/// Lets the angles that nobody set be the angle of repose, as thermal_settings() takes them.
void follow_repose(Parameters& parameters);
/// With the sediment's settings in it; what hangs on the layers that are there is the simulation's.
WaterSettings water_settings_of(const Parameters& parameters);
/// What the ledger counts regolith and load as.
SolidWeights weights_of(const Parameters& parameters);

/// Whether a parameter of this name begins inflow and wave maker anew when it is set.
bool drives_edges(const std::string& name);

}  // namespace talus

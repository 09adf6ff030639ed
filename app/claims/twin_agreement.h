#pragma once
#include <cstddef>

#include "sim/passes/thermal_settings.h"
#include "sim/passes/water.h"

namespace talus::claims {

/// A pass on the device against its twins on the processor (law 4).
struct TwinAgreement {
    std::size_t differing = 0;  ///< samples whose bits are not the float twin's
    std::size_t changed = 0;    ///< samples that the pass changed
    std::size_t samples = 0;
    double of_double = 0;  ///< L1 distance from the double twin: of the depth, or of what moved, relative
};

/// Dabs of all modes and slides, in turn, over so many sub-steps on a terrain of two layers with a mask.
TwinAgreement brush_and_slopes_against_twin(int substeps, ThermalScheme scheme = ThermalScheme::gradient);

/// Water that sloshes in a basin of 131 x 97 samples for ten ticks.
struct WaterCase {
    int order = 2;
    double manning_s_per_m13 = 0;
    double rain_m_per_s = 0;
    EdgeKind north = EdgeKind::wall;
    EdgeKind south = EdgeKind::wall;
    EdgeKind west = EdgeKind::wall;
    EdgeKind east = EdgeKind::wall;
    bool knows_bed_beyond = false;  ///< edges see the basin's bed go on
    bool driven = false;            ///< rain, inflow, level and waves follow tables
};
TwinAgreement water_against_twin(const WaterCase& c);
/// The same water, eroding; the worst of water, ground and load. Its Manning's n is 0.03.
TwinAgreement sediment_against_twin(const WaterCase& c);

}  // namespace talus::claims

#pragma once
#include <algorithm>

#include "sim/passes/water_settings.h"

namespace talus {

/// Whether rain differs from place to place.
inline bool has_rain_map(const WaterSettings& settings) {
    return settings.rain_painted || (settings.rain_masked && settings.rain_m_per_s > 0);
}

/// Whether roughness or infiltration differ from place to place.
inline bool has_land_cover(const WaterSettings& settings) {
    return settings.manning_painted || settings.infiltration_painted;
}

/// Whether an edge is of kind inflow: what passes it is given.
inline bool has_inflow(const WaterSettings& settings) {
    return std::find(settings.edges.begin(), settings.edges.end(), EdgeKind::inflow) != settings.edges.end();
}

/// Whether that differs along an edge.
inline bool spreads_by_conveyance(const WaterSettings& settings) {
    return settings.inflow_by_conveyance && has_inflow(settings);
}

/// Whether rain, infiltration and evaporation act in this stage: after every Euler step.
inline bool has_sources(const WaterSettings& settings, int stage) {
    const bool any = settings.rain_m_per_s > 0 || settings.rain_painted ||
                     settings.infiltration_m_per_s > 0 || settings.infiltration_painted ||
                     settings.evaporation_m_per_s > 0;
    return any && (settings.order == 1 || stage == 2);
}

/// Runs the parts of a sub-step of known length, on the device (sim/passes/water.h) or in the twin
/// (sim/passes/water_twin.h). Each of the two stages begins with the ghost samples beyond the edges; the
/// first one also runs the springs. The exchange of solid with the bed comes last. At order 1 the stages are
/// two successive Euler steps, at order 2 the two stages of one step.
template <typename FillGhosts, typename RunStage, typename Exchange>
void run_substep(const WaterSettings& settings, FillGhosts&& fill_ghosts, RunStage&& run_stage,
                 Exchange&& exchange) {
    for (const int stage : {1, 2}) {
        fill_ghosts(stage);
        run_stage(stage);
    }
    if (settings.sediment.carried) exchange();
}

}  // namespace talus

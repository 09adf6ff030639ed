#pragma once
#include "sim/passes/water_settings.h"

namespace talus {

/// Whether rain differs from place to place.
inline bool has_rain_map(const WaterSettings& settings) {
    return settings.rain_painted || (settings.rain_masked && settings.rain_m_per_s > 0);
}

/// Whether rain, infiltration and evaporation act in this stage: after every Euler step.
inline bool has_sources(const WaterSettings& settings, int stage) {
    const bool any = settings.rain_m_per_s > 0 || settings.rain_painted ||
                     settings.infiltration_m_per_s > 0 || settings.evaporation_m_per_s > 0;
    return any && (settings.order == 1 || stage == 2);
}

/// A sub-step of the water in its order, once its length is known: equal Euler steps
/// that follow each other, which at order 2 are the stages of one step. For the device (sim/passes/water.h)
/// and for the twin (sim/passes/water_twin.h). Before each stage, 1 and 2, the samples beyond the edges are
/// made; before the first one springs give. The exchange of solid with the bed ends it.
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

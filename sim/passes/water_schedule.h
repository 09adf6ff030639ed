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

/// The parts of a sub-step of the water, once its length is known, for the device (sim/passes/water.h) and
/// for the twin (sim/passes/water_twin.h): for each of its two stages the samples beyond the edges (before
/// the first, the springs too), then the stage; last the exchange of solid with the bed. Of order 1 the
/// stages are Euler steps that follow each other, of order 2 those of one step.
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

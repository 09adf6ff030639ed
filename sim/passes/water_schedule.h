#pragma once
#include "sim/passes/water_settings.h"

namespace talus {

/// Equal Euler steps that follow each other in a sub-step: at order 2 they are the stages of one step.
inline int euler_steps(const WaterSettings& settings) {
    return settings.order == 1 ? 2 : 1;
}

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

/// What friction in an Euler step follows: gravity times the square of Manning's n.
inline double friction_of(const WaterSettings& settings) {
    return settings.gravity_m_per_s2 * settings.manning_s_per_m13 * settings.manning_s_per_m13;
}

/// A sub-step of the water in its order, once its length is known; for the device (sim/passes/water.h) and
/// for the twin (sim/passes/water_twin.h). Before each stage, 1 and 2, the samples beyond the edges are made;
/// before the first one springs give. The exchange of solid with the bed ends it.
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

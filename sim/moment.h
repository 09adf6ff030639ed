#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "sim/budget.h"
#include "sim/parameters.h"
#include "sim/terrain/georeference.h"
#include "sim/terrain/stamp.h"
#include "sim/terrain/terrain_state.h"

namespace talus {

/// A simulation's state beside the layers and books on the device: what undo restores with them.
struct Moment {
    Clock clock;
    Parameters parameters;
    std::vector<Spring> springs;
    std::vector<Drive> drives;
    std::vector<Event> events;
    double edges_since_s = 0;
    double sea_m3 = 0;     ///< water that sea levels brought so far
    double booked_m3 = 0;  ///< solid that changes of porosity and acceleration, and blurs, brought so far
    LedgerStart ledger = LedgerStart();  ///< what it counts from
    std::optional<Georeference> georeference = std::nullopt;
    std::shared_ptr<const Stamp> stamp = nullptr;  ///< what dabs of a stamp press; none: nothing was chosen
};

}  // namespace talus

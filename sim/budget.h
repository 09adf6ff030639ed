#pragma once
#include <string>

#include "sim/terrain/grid.h"

namespace talus {

namespace gpu {
class Buffer;
}

/// What a metre of each store counts as solid: bedrock 1, regolith 1 - porosity, suspended the acceleration.
struct SolidWeights {
    double regolith = 1;
    double suspended = 1;
};

/// What there was when the ledger was begun, m³.
struct LedgerStart {
    double solid_m3 = 0;
    double water_m3 = 0;
};

/// Where the water came from and went, m³ since the start.
struct WaterBooks {
    double rain_m3 = 0;
    double springs_m3 = 0;
    double edges_in_m3 = 0;
    double edges_out_m3 = 0;
    double losses_m3 = 0;  ///< by infiltration and evaporation
    double sea_m3 = 0;
    double brush_in_m3 = 0;
    double brush_out_m3 = 0;
    double in_m3() const { return rain_m3 + springs_m3 + edges_in_m3 + sea_m3 + brush_in_m3; }
    double out_m3() const { return edges_out_m3 + losses_m3 + brush_out_m3; }
};

/// The budget terms of the terrain: its inflows and outflows since the ledger was begun, without the stores.
/// Solid is in m³, weighted by SolidWeights.
struct BudgetTerms {
    double solid_in_m3 = 0;  ///< by brushes, and what changed its weight
    double solid_out_m3 = 0;
    double solid_edges_in_m3 = 0;
    double solid_edges_out_m3 = 0;
    WaterBooks water;
};

/// Terms that a pass books on the device while it works (law 3).
struct Book {
    /// Adds what the words, or a copy of them, say. Waits for the device.
    using Add = void (*)(const gpu::Buffer& words, const Grid& grid, const SolidWeights& weights,
                         BudgetTerms& terms);
    std::string name;  ///< of this book alone: undo knows it by that
    gpu::Buffer* words;
    Add add;
};

}  // namespace talus

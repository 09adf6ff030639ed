#pragma once
#include "sim/passes/brush.h"
#include "sim/passes/water.h"
#include "sim/terrain/terrain.h"

namespace talus {

/// Where rock and water are, in m³, summed in double. Solid = bedrock + regolith (regolith of porosity 0
/// until sediment has its own).
struct LedgerReading {
    double solid_initial = 0;
    double solid_final = 0;
    double solid_in = 0;   ///< added by brushes
    double solid_out = 0;  ///< taken by brushes
    double moved_m3 = 0;   ///< sum of |ground - ground at the start| dx dy / 2

    double water_initial = 0;
    double water_final = 0;
    double water_in = 0;   ///< rain, springs, edges, sea and brushes
    double water_out = 0;  ///< edges, infiltration, evaporation and brushes

    /// Against all water that there ever was.
    double water_drift_relative() const {
        const double all = water_initial + water_in;
        return all > 0 ? (water_final - water_initial - water_in + water_out) / all : 0;
    }
    double closing_error_m3() const { return solid_final - solid_initial - solid_in + solid_out; }
    /// Against what moved (law 3); 0 where nothing moved and nothing is missing.
    double closing_error_of_moved() const;
};

/// Sums the terrain on the device, tile by tile, and what came and went by its books.
class Ledger {
  public:
    explicit Ledger(const Terrain& terrain);
    /// Waits for the device. Not for use within a frame (law 7).
    LedgerReading read(const Terrain& terrain, const Brush& brush, const WaterBooks& water);

  private:
    glm::dvec3 sum(const Terrain& terrain);

    gpu::Program program_;
    gpu::Buffer tile_sums_;
    gpu::Program water_program_;
    glm::dvec3 initial_{0};
};

}  // namespace talus

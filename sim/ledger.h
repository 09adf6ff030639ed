#pragma once
#include "sim/passes/brush.h"
#include "sim/terrain/terrain.h"

namespace talus {

/// Where the rock is, in m³, summed in double. Solid = bedrock + regolith (regolith of porosity 0 until
/// sediment has its own).
struct LedgerReading {
    double solid_initial = 0;
    double solid_final = 0;
    double solid_in = 0;   ///< added by brushes
    double solid_out = 0;  ///< taken by brushes
    double moved_m3 = 0;   ///< sum of |ground - ground at the start| dx dy / 2

    double closing_error_m3() const { return solid_final - solid_initial - solid_in + solid_out; }
    /// Against what moved (law 3); 0 where nothing moved and nothing is missing.
    double closing_error_of_moved() const;
};

/// Sums the terrain on the device, tile by tile, and the books of its brush.
class Ledger {
  public:
    explicit Ledger(const Terrain& terrain);
    /// Waits for the device. Not for use within a frame (law 7).
    LedgerReading read(const Terrain& terrain, const Brush& brush);

  private:
    glm::dvec2 sum(const Terrain& terrain);

    gpu::Program program_;
    gpu::Buffer tile_sums_;
    double initial_ = 0;
};

}  // namespace talus

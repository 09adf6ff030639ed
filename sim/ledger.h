#pragma once
#include <vector>

#include "sim/budget.h"
#include "sim/gpu/buffer.h"
#include "sim/gpu/program.h"
#include "sim/parameters.h"
#include "sim/terrain/terrain.h"

namespace talus {

/// The solid weights under these parameters. They are rounded to float as in the shaders: otherwise the
/// ledger would count the rounding error as solid.
SolidWeights solid_weights(const Parameters& parameters);

/// Where rock and water are, in m³, summed in double (law 3).
struct LedgerReading {
    double bedrock = 0;  ///< as solid, each
    double regolith = 0;
    double suspended = 0;
    double solid_initial = 0;
    double solid_final = 0;
    double solid_in = 0;  ///< by brushes and edges, and what changed its weight
    double solid_out = 0;
    double solid_edges_out = 0;  ///< of it, by edges
    double eroded_m3 = 0;        ///< net: where the ground is lower than at the start
    double deposited_m3 = 0;     ///< net: where it is higher

    double water_initial = 0;
    double water_final = 0;
    double water_in = 0;   ///< rain, springs, edges, sea and brushes
    double water_out = 0;  ///< edges, infiltration, evaporation and brushes

    /// Against all water that there ever was.
    double water_drift_relative() const {
        const double all = water_initial + water_in;
        return all > 0 ? (water_final - water_initial - water_in + water_out) / all : 0;
    }
    /// Half of all that the ground changed by.
    double moved_m3() const { return (eroded_m3 + deposited_m3) / 2; }
    double closing_error_m3() const { return solid_final - solid_initial - solid_in + solid_out; }
    /// Against what moved (law 3), and against what was eroded; 0 where nothing is missing.
    double closing_error_of_moved() const;
    double closing_error_of_eroded() const;
};

/// Sums the terrain on the device, tile by tile, and tells from the sums and the books what the ledger reads.
class Ledger {
  public:
    explicit Ledger(const Terrain& terrain);

    /// What there is now, to begin from. Waits for the device.
    LedgerStart begin(const Terrain& terrain, const SolidWeights& weights);

    /// Sums the terrain as it is, without waiting: two times four doubles a tile.
    void sum(const Terrain& terrain);
    const gpu::Buffer& tile_sums() const { return tile_sums_; }

    /// `tile_sums`: as sum() left them.
    LedgerReading reading(const LedgerStart& start, const std::vector<glm::dvec4>& tile_sums,
                          const SolidWeights& weights, const BudgetTerms& terms) const;

  private:
    double area_m2_;
    gpu::Program program_;
    gpu::Buffer tile_sums_;
    gpu::Program water_program_;
    gpu::Program loaded_program_;
};

}  // namespace talus

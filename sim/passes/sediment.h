#pragma once
#include <array>
#include <map>

#include "sim/budget.h"
#include "sim/gpu/buffer.h"
#include "sim/gpu/program.h"
#include "sim/gpu/uniform_block.h"
#include "sim/passes/sediment_step.h"
#include "sim/terrain/terrain.h"

namespace talus {

/// The maps that an exchange counts, or goes by, where the terrain has them.
struct SedimentMaps {
    bool wear = false;
    bool land_cover = false;  ///< Manning's n differs from place to place
};

/// The exchange between bed and water after each of the water's sub-steps, and the books of solid that passes
/// the edges. The transport itself is part of the water's stages (sim/passes/water.h).
class Sediment {
  public:
    explicit Sediment(const Grid& grid);

    /// Before each tick of the water.
    void begin_tick(const WaterSettings& water) { numbers.set(sediment_numbers(water)); }
    /// On the tiles of the list, for a sub-step of the water's clock. `activity`: the water's, which it wakes
    /// where the bed moves. `tick`: the water's numbers.
    void exchange(Terrain& terrain, const gpu::Buffer& list, const gpu::Buffer& activity,
                  const gpu::Buffer& clock, const gpu::Buffer& tick, SedimentMaps maps);

    /// Of solid that passed the edges.
    Book book();

    /// Metres of solid in and out round the map, as they count for the bed, pairs of doubles.
    gpu::Buffer edge_books;
    gpu::UniformBlock<SedimentNumbers> numbers{"sediment numbers"};

  private:
    gpu::Program& program_of(bool painted, bool worn, bool land_cover);

    std::map<std::array<bool, 3>, gpu::Program> programs_;  // by what program_of() asks for
    gpu::Program bed_program_;
};

}  // namespace talus

#pragma once
#include <map>

#include "sim/gpu/buffer.h"
#include "sim/gpu/program.h"
#include "sim/terrain/terrain.h"

namespace talus {

/// How the inflow spreads along the map's edges by conveyance, found anew for each tick
/// (shaders/maths/conveyance.glsl).
class InflowShares {
  public:
    explicit InflowShares(const Grid& grid);

    /// Over the terrain's water bed. `numbers`: the water's of the tick. `land_cover`: Manning's n is that of
    /// the terrain's layer.
    void find(const Terrain& terrain, const gpu::Buffer& numbers, const gpu::Buffer& clock, bool land_cover);

    /// Of each place of the edges (maths/edge_places.glsl), 1 on average.
    gpu::Buffer shares;

  private:
    std::map<bool, gpu::Program> programs_;  // by land cover
};

}  // namespace talus

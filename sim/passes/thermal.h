#pragma once
#include <map>

#include "sim/gpu/program.h"
#include "sim/gpu/uniform_block.h"
#include "sim/passes/thermal_step.h"
#include "sim/terrain/terrain.h"

namespace talus {

/// Runs thermal erosion on the tiles that changed in the last sub-step, and their neighbours: the others
/// would keep their bits (law 2).
class Thermal {
  public:
    explicit Thermal(const Terrain& terrain);
    void substep(Terrain& terrain, const ThermalStep& step);

  private:
    gpu::Program& program_of(ThermalScheme scheme, bool wet, bool masked, bool worn);

    std::map<int, gpu::Program> programs_;  // by scheme, wet, masked and worn
    gpu::UniformBlock<ThermalNumbers> numbers_;
    TileList active_;
    Tiles::Reader read_;
};

}  // namespace talus

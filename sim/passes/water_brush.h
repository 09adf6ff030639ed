#pragma once
#include "sim/budget.h"
#include "sim/gpu/buffer.h"
#include "sim/gpu/program.h"
#include "sim/passes/brush.h"
#include "sim/terrain/terrain.h"

namespace talus {

/// Applies dabs of water, and books per tile what they add and take (law 3).
class WaterBrush {
  public:
    explicit WaterBrush(const Terrain& terrain);
    /// Raise adds depth, lower takes it. The terrain must have a water layer.
    void dab(Terrain& terrain, const Dab& dab);

    /// Of water that came and went.
    Book book();

  private:
    gpu::Buffer book_;  // metres of depth in and out, a pair of doubles a tile
    gpu::UniformBlock<DabNumbers> numbers_{"dab numbers"};
    gpu::Program program_;
};

}  // namespace talus

#pragma once
#include "sim/gpu/program.h"
#include "sim/passes/brush.h"
#include "sim/terrain/terrain.h"

namespace talus {

/// Applies dabs of paint: they bring a painted layer nearer to the dab's target.
class Paint {
  public:
    Paint() : program_("sim/paint.comp") {}
    /// The dab must be one of paint; the terrain gets a painted layer where it has none.
    void dab(Terrain& terrain, const Dab& dab);

  private:
    gpu::UniformBlock<DabNumbers> numbers_{"dab numbers"};
    gpu::Program program_;
};

}  // namespace talus

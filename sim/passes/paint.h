#pragma once
#include "sim/gpu/program.h"
#include "sim/passes/brush.h"
#include "sim/terrain/terrain.h"

namespace talus {

/// Applies dabs of paint: they bring a painted number nearer to the dab's target.
class Paint {
  public:
    Paint() : program_("sim/paint.comp"), land_cover_program_({"sim/paint.comp"}, {"LAND_COVER 1"}) {}
    /// The dab must be one of paint; the terrain gets the layer of its number where it has none.
    void dab(Terrain& terrain, const Dab& dab);

  private:
    gpu::UniformBlock<DabNumbers> numbers_{"dab numbers"};
    gpu::Program program_;
    gpu::Program land_cover_program_;
};

}  // namespace talus

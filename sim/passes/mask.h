#pragma once
#include "sim/gpu/program.h"
#include "sim/passes/mask_settings.h"
#include "sim/terrain/terrain.h"

namespace talus {

/// Makes the painted mask out of the terrain.
class Mask {
  public:
    Mask() : program_("sim/mask.comp") {}
    /// The terrain gets a painted layer where it has none.
    void make(Terrain& terrain, const MaskSettings& settings);

  private:
    gpu::Program program_;
};

}  // namespace talus

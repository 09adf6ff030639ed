#pragma once
#include <map>

#include "sim/gpu/program.h"
#include "sim/passes/mask_settings.h"
#include "sim/terrain/terrain.h"

namespace talus {

/// Makes the painted mask out of the terrain.
class Mask {
  public:
    /// The terrain gets a painted layer where it has none. Of a layer that the terrain has not, all is 0, and
    /// water has arrived nowhere.
    void make(Terrain& terrain, const MaskSettings& settings);

  private:
    gpu::Program& program_of(MaskSource source);

    std::map<MaskSource, gpu::Program> programs_;
};

}  // namespace talus

#pragma once
#include "sim/gpu/program.h"
#include "sim/terrain/terrain.h"

namespace talus {

/// Keeps the inundation map: the largest depth so far, and when water arrived.
class Inundation {
  public:
    explicit Inundation(const Terrain& terrain);
    /// Takes the water as it stands at a simulated time. Looks only at tiles whose water changed since the
    /// last time. The terrain must have a water layer.
    void record(Terrain& terrain, double simulated_s);

  private:
    gpu::Program program_;
    TileList changed_;
    Tiles::Reader read_;
};

}  // namespace talus

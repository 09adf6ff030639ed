#pragma once
#include "sim/gpu/readback.h"
#include "sim/terrain/tiles.h"

namespace talus::app {

/// In how many tiles something moved within about half a second.
class Activity {
  public:
    struct Counts {
        int slope_tiles = 0;  ///< the ground slid, or a brush moved it
        int water_tiles = 0;
    };
    const Counts& counts() const { return counts_; }
    /// Takes what has come, without waiting, and asks anew twice a second. Once a frame, while somebody
    /// looks.
    void follow(const Tiles& tiles);
    /// For another terrain.
    void forget();

  private:
    Counts counts_;
    gpu::Readback stamps_;
    Tiles::Reader asked_at_;  // of the tiles, when it was asked for
    Tiles::Reader since_;     // and the time before
    double asked_at_s_ = 0;
};

}  // namespace talus::app

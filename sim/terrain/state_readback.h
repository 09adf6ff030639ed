#pragma once
#include <optional>
#include <vector>

#include "sim/gpu/readback.h"
#include "sim/terrain/terrain.h"

namespace talus {

/// Reads a terrain's layers without waiting: start() copies them on the device as they are, poll() fetches a
/// layer at a time as they come.
///
///     if (!readback.pending()) readback.start(terrain);
///     if (auto state = readback.poll()) ...
class StateReadback {
  public:
    void start(const Terrain& terrain);
    bool pending() const { return state_.has_value(); }
    /// The layers, once the last one has come; all else is the caller's. Nothing before.
    std::optional<TerrainState> poll();
    void cancel();

  private:
    std::optional<TerrainState> state_;
    gpu::Readback solid_;
    gpu::Readback start_;
    std::vector<gpu::Readback> layers_;  // as layers() has them; those of the solid stay unused
};

}  // namespace talus

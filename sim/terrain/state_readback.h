#pragma once
#include <array>
#include <optional>

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
    /// The layers, once the last one has come; clock, springs and georeference are the caller's. Nothing
    /// before.
    std::optional<TerrainState> poll();
    void cancel();

  private:
    std::optional<TerrainState> state_;
    std::array<gpu::Readback, 5> layers_;  // solid, and the optional ones
};

}  // namespace talus

#pragma once
#include <optional>
#include <vector>

#include "sim/gpu/readback.h"
#include "sim/terrain/terrain.h"

namespace talus::app {

/// The ground below the camera on the CPU, without waiting for the device: samples around a place, read anew
/// when the place nears their edge or the ground changes. They are a frame or two old, and exact where the
/// ground rests.
class GroundProbe {
  public:
    /// To be called every frame with where the camera is.
    void follow(const Terrain& terrain, glm::dvec2 place_m);
    /// Height of the bilinear surface; none beside the terrain or before the samples have come.
    std::optional<double> height_m(const Grid& grid, glm::dvec2 place_m) const;
    /// True while samples are on their way.
    bool pending() const { return readback_.pending(); }
    /// For another terrain, or when nobody asks any more.
    void forget();

  private:
    gpu::Readback readback_;
    gpu::Region asked_;
    std::uint64_t asked_changes_ = 0;
    gpu::Region here_;
    std::uint64_t changes_ = 0;
    std::vector<float> samples_;
};

}  // namespace talus::app

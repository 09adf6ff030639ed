#pragma once
#include <optional>
#include <vector>

#include "app/core/ground_samples.h"
#include "sim/gpu/readback.h"

namespace talus::app {

/// The ground below the camera on the CPU, without waiting for the device: samples around a place, read anew
/// when the place nears their edge or the ground changes. They are a frame or two old, and exact where the
/// ground rests.
class GroundProbe {
  public:
    /// To be called every frame with the ground where the camera is; none: it is beside the
    /// terrain.
    void follow(const std::optional<GroundSamples>& ground);
    /// Height of the bilinear surface there; none beside the terrain and before the samples have
    /// come.
    std::optional<double> height_m(const std::optional<GroundSamples>& ground) const;
    /// True while samples are on their way.
    bool pending() const { return readback_.pending(); }
    /// For another terrain, or when nobody asks any more.
    void forget();

  private:
    // Which samples are read.
    struct Part {
        glm::ivec2 first{0};
        glm::ivec2 size{0};
        std::uint64_t which = 0;
        std::uint64_t changes = 0;
    };
    gpu::Readback readback_;
    Part asked_;
    Part here_;
    std::vector<float> samples_;
};

}  // namespace talus::app

#pragma once
#include <optional>
#include <vector>

#include "sim/gpu/fence.h"
#include "sim/gpu/texture.h"

namespace talus::gpu {

/// Reads texels of a float texture, or the start of a buffer, without waiting: start() copies on the device,
/// poll() gives them once they are there.
///
///     if (!readback.pending()) readback.start(hits, {x, y, 1, 1});
///     if (auto texels = readback.poll()) ...
class Readback {
  public:
    bool pending() const { return static_cast<bool>(fence_); }
    void start(const Texture& texture, const Region& region);
    void start(const Buffer& buffer, std::size_t bytes);
    /// All of a buffer that nobody else needs any more.
    void start(Buffer&& buffer);
    /// All components of the region's texels, row by row; none while the device is still at it, or nothing
    /// was started.
    std::optional<std::vector<float>> poll();
    /// The same, waiting for the device; something must have been started. Not for use within a frame (law
    /// 7).
    std::vector<float> wait();

    /// Forgets what was started.
    void cancel();

  private:
    std::vector<float> take();

    Buffer buffer_;
    bool owned_ = false;  // given away by its owner: let go once it is read
    Fence fence_;
};

}  // namespace talus::gpu

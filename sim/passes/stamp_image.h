#pragma once
#include <memory>

#include "sim/gpu/texture.h"
#include "sim/terrain/stamp.h"

namespace talus {

/// A stamp's heights on the device, written when another stamp is asked for.
class StampImage {
  public:
    /// There must be a stamp.
    const gpu::Texture& of(const std::shared_ptr<const Stamp>& stamp);

  private:
    gpu::Texture texture_;
    std::shared_ptr<const Stamp> there_;
};

}  // namespace talus

#pragma once
#include <optional>
#include <vector>

#include "sim/gpu/profile.h"

namespace talus::app {

/// What passes took, gathered over half a second at a time.
class PassTimes {
  public:
    struct Gathered {
        std::vector<gpu::PassTime> passes;
        double span_s = 0;
    };
    /// Once a frame: `shown`, whether somebody looks at them, after this much wall time. None: not half a
    /// second yet.
    std::optional<Gathered> follow(bool shown, double passed_s);

  private:
    bool profiling_ = false;
    Gathered gathered_;
};

}  // namespace talus::app

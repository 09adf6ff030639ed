#pragma once
#include <cstdint>

namespace talus {

/// What a pass had the device do so far.
struct PassWork {
    std::uint64_t substeps = 0;
    std::uint64_t tiles = 0;  ///< computed in them together; 0 where the pass does not count them
};

}  // namespace talus

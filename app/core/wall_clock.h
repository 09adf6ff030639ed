#pragma once
#include <chrono>

namespace talus::app {

/// Seconds of a clock on the wall that never goes back; only differences mean something.
inline double wall_clock_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace talus::app

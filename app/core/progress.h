#pragma once
#include <functional>

namespace talus::app {

/// Told of the share of long work that is done, 0 to 1. False: the work is to end.
using Progress = std::function<bool(double share)>;

}  // namespace talus::app

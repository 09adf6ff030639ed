#pragma once
#include <functional>

#include "sim/error.h"

namespace talus::app {

/// Told of the share of long work that is done, 0 to 1. False: the work is to end.
using Progress = std::function<bool(double share)>;

/// Long work was ended by whom it was told to.
class Interrupted : public Error {
  public:
    using Error::Error;
};

}  // namespace talus::app

#pragma once
#include <vector>

#include "sim/parameters.h"

namespace talus::app {

/// Parameters of the window: brush, camera, undo. They change what a hand does next, never a recorded
/// operation.
std::vector<Parameter> app_parameters();

/// Every declared parameter: simulation, drawing, window.
std::vector<Parameter> all_parameters();

}  // namespace talus::app

#pragma once
#include <initializer_list>

#include "sim/simulation_parameters.h"

namespace talus {

/// The simulation's parameters with these assignments, "section.name=value".
inline Parameters parameters_with(std::initializer_list<const char*> assignments) {
    Parameters all(simulation_parameters());
    for (const char* assignment : assignments) all.set_assignment(assignment);
    return all;
}

}  // namespace talus

#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "app/core/workspace.h"

namespace talus::app {

/// What somebody put into a scene that is no operation of the simulation.
struct Placed {
    std::vector<glm::dvec2> gauges_m;
    std::vector<Section> sections;
    std::vector<glm::dvec2> path_m;  ///< of a path that is not in the ground
    std::vector<NamedCamera> cameras;
    bool operator==(const Placed&) const = default;
};

}  // namespace talus::app

#pragma once
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "sim/terrain/stamp.h"

namespace talus {

/// A stamp that Talus makes.
struct StampShape {
    std::string name;
    std::string what;
    /// Height at a place, both in halves of the stamp's width, from its middle; 0 on its border.
    double (*height)(glm::dvec2 place);
};
/// Crater (bowl, rim and ejecta; Pike 1977, McGetchin et al. 1973), peaked_crater (flat floor and a central
/// peak; Pike 1985), volcano, mesa, dunes (transverse, their lee at the angle of repose).
const std::vector<StampShape>& stamp_shapes();
/// It as a stamp, 257 x 257 samples, 1 km wide, which is as high as it is wide in proportion. The same bits
/// on every machine. Throws talus::Error where there is none of the name.
Stamp shaped_stamp(const std::string& name);

}  // namespace talus

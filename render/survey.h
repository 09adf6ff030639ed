#pragma once
#include <string>
#include <vector>

#include "render/camera.h"

namespace talus::render {

/// A camera with a name for reports.
struct NamedCamera {
    std::string name;
    Camera camera;
};

/// Twelve places to look at a terrain from, for measuring: level and pitched, straight down, from a valley,
/// below ground, along an axis and a diagonal, walking, through the side, from far away and from below.
std::vector<NamedCamera> survey(const Grid& grid, const std::vector<float>& heights);

}  // namespace talus::render

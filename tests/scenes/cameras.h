#pragma once
#include <string>
#include <vector>

#include "render/camera.h"
#include "tests/scenes/scenes.h"

namespace talus::scenes {

struct NamedCamera {
    std::string name;
    Camera camera;
};

/// Twelve places to look from: level and pitched, straight down, from a valley, below ground, along an axis
/// and a diagonal, walking, through the side, from far away and from below.
std::vector<NamedCamera> cameras(const Scene& scene);

}  // namespace talus::scenes

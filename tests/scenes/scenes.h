#pragma once
#include <string>
#include <vector>

#include "sim/terrain/grid.h"

namespace talus::scenes {

/// A terrain that tests share.
struct Scene {
    Grid grid;
    std::vector<float> heights;
};

/// fbm, spikes and, where TALUS_DATA names the folder of real elevation files, bigtujunga and coast; ridges
/// and hills of the same sizes without it.
std::vector<std::string> names();
Scene make(const std::string& name);

}  // namespace talus::scenes

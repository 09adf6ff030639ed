#pragma once
#include <string>
#include <vector>

#include "render/camera.h"
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

/// Hills that end in a plain and the sea: from over its shore the near ground is best drawn by mesh, the
/// hills by rays, and the far plain by rays that end early.
Scene shore();
/// Eyes along it.
std::vector<render::Camera> shore_views();

}  // namespace talus::scenes

#pragma once
#include "render/overview.h"
#include "sim/parameters.h"

namespace talus::app {

/// The camera that a terrain is first seen by, as camera.mode says: from the south-west, or straight down. It
/// holds all of the terrain, in a picture of this aspect (width by height), and while the camera turns
/// around. heights_m: lowest and highest. view: app_parameters() are among them.
render::Camera first_look(const Parameters& view, const Grid& grid, glm::dvec2 heights_m, double aspect,
                          bool all_around = false);

}  // namespace talus::app

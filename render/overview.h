#pragma once
#include "render/camera.h"

namespace talus::render {

/// The picture that a terrain is to be framed in.
struct Framing {
    double aspect = 16.0 / 9;  ///< width by height
    double fov_deg = 50;       ///< vertical
    bool all_around =
        false;  ///< the terrain stays within the picture while the camera turns about its middle
};

/// A view from the south-west that holds all of the terrain with its heights, as near as that allows, for a
/// first look. The target is the point of the view's axis that is nearest to the terrain's middle.
Camera overview(const Grid& grid, double lowest_m, double highest_m, const Framing& framing = {});

/// An orthographic view straight down that holds all of the terrain: a map, north at its top.
Camera top_view(const Grid& grid, double highest_m, const Framing& framing = {});

/// The eye of an orthographic view straight down sees what lies below it: brings it well over the highest
/// ground where it is not.
void keep_over(Camera& camera, const Grid& grid, double highest_m);

}  // namespace talus::render

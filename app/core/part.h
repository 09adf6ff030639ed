#pragma once
#include "app/core/session.h"
#include "sim/parameters.h"
#include "sim/terrain/reshape.h"

namespace talus::app {

/// The part of a terrain in tiles that `map.west_m` and its like say.
Rectangle part_of(const Parameters& view);
void set_part(Parameters& view, const Rectangle& part);

/// What opens that part of the terrain in tiles that the session looks at, to be worked in. Throws
/// talus::Error where it has too few or too many samples.
SceneRequest request_for_part(const Session& session);

/// What opens all of what the session's scene was cut out of, to be looked at. The scene must have been cut
/// out.
SceneRequest request_for_whole(const Session& session);

}  // namespace talus::app

#pragma once
#include "render/methods/method.h"

namespace talus::render {

/// Draws parallel views (Camera::parallel_m), whichever method is chosen: each pixel's ray starts in a column
/// and row of its own and is cast onto the exact surface. Without beams: a ray straight down meets the patch
/// that it starts over. Heeds Frame::redraw. Kinds are those of ray_kinds().
Method make_parallel(Detail detail);

}  // namespace talus::render

#pragma once

namespace talus {

/// From how many pixels a patch on triangles are cheaper than rays on the current device: the hybrid method's
/// choice. Measured with the methods themselves on a small terrain, in under 0.3 s; rounded to a power of the
/// square root of 2, so that noise seldom changes it.
double measure_patch_pixels();

}  // namespace talus

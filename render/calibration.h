#pragma once

namespace talus::render {

/// From how many pixels a patch on triangles are cheaper than rays on the current device: the hybrid method's
/// choice. Measured with the methods themselves on a small terrain; rounded to a power of the square root of
/// 2, so that noise seldom changes it. software: the device is this process, so CPU time counts. Where
/// shaders were never compiled, compiling takes most of the time.
double measure_patch_pixels(bool software);

}  // namespace talus::render

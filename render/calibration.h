#pragma once

namespace talus::render {

/// The size of a patch, in pixels, from which triangles are cheaper than rays on the current device. The
/// hybrid method chooses by it. Measured with that method on a small terrain; rounded to a power of the
/// square root of 2, so that noise seldom changes it. software: the device is this process, so CPU time
/// counts. If the shaders were never compiled, compiling takes most of the time.
double measure_patch_pixels(bool software);

}  // namespace talus::render

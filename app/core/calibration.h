#pragma once
#include "sim/gpu/context.h"

namespace talus::app {

/// measure_patch_pixels() of the device, which is current; measured once a device and driver, then kept in
/// the user's cache folder (XDG_CACHE_HOME or ~/.cache, talus/calibration.toml). Where nothing can be kept,
/// measured once a run.
double patch_pixels(const gpu::Device& device);

}  // namespace talus::app

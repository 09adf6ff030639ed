#pragma once
#include "sim/gpu/texture.h"

namespace talus::render {

/// Noise for the ground's materials that repeats without a seam, filtered for any distance: four channels of
/// value noise, broad, middle, fine and finest, each 0 to 1 with mean one half.
gpu::Texture grain_texture();

}  // namespace talus::render

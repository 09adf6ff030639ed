#pragma once
#include <cstdint>
#include <vector>

#include "render/hits_target.h"

namespace talus::render {

/// A picture's colours from an RGBA8 image: rows of RGB from the top. Waits for the device.
std::vector<std::uint8_t> read_picture_rgb(const gpu::Texture& colour, int width, int height);
/// Distances along its pixels' rays, rows from the top. Waits for the device.
std::vector<float> read_picture_depth(const HitsTarget& target, int width, int height);

}  // namespace talus::render

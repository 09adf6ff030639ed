#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

namespace talus::io {

/// Writes a picture as PNG, 8 bits a channel, top row first. Throws talus::Error.
void write_rgb(const std::filesystem::path& path, int width, int height,
               const std::vector<std::uint8_t>& rgb);

/// Writes one float a pixel as EXR, channel Z, top row first. Throws talus::Error.
void write_depth(const std::filesystem::path& path, int width, int height, const std::vector<float>& depth);

}  // namespace talus::io

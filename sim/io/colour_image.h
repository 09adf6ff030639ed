#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

namespace talus {

/// A picture for screens: rows of RGBA bytes, top row first.
struct ColourImage {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;
};

/// Reads any picture that OpenImageIO knows (PNG, JPEG, TIFF …), of one, three or four channels, at most
/// 16384 pixels a side. Throws talus::Error.
ColourImage read_colour_image(const std::filesystem::path& path);

}  // namespace talus

#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace talus::io {

/// A picture for screens: rows of RGBA bytes, top row first.
struct ColourImage {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;
};

/// As OpenGL 4.5 promises for a texture.
constexpr int largest_picture_side = 16384;

/// Reads any picture that OpenImageIO knows (PNG, JPEG, TIFF …), of one, three or four channels, at most
/// 16384 pixels a side. Throws talus::Error.
ColourImage read_colour_image(const std::filesystem::path& path);

/// The same from a PNG in memory; `name` stands in errors.
ColourImage decode_png(std::string_view bytes, const std::string& name);

}  // namespace talus::io

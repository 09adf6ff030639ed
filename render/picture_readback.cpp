#include "render/picture_readback.h"

namespace talus::render {

std::vector<std::uint8_t> read_picture_rgb(const gpu::Texture& colour, int width, int height) {
    std::vector<std::uint8_t> rgba(static_cast<std::size_t>(width) * height * 4);
    colour.read({0, 0, width, height}, std::as_writable_bytes(std::span(rgba)));
    std::vector<std::uint8_t> rgb;
    rgb.reserve(static_cast<std::size_t>(width) * height * 3);
    for (int y = height - 1; y >= 0; --y)
        for (int x = 0; x < width; ++x) {
            const std::size_t at = (static_cast<std::size_t>(y) * width + x) * 4;
            rgb.insert(rgb.end(), {rgba[at], rgba[at + 1], rgba[at + 2]});
        }
    return rgb;
}

std::vector<float> read_picture_depth(const HitsTarget& target, int width, int height) {
    const std::vector<float> bottom_up = target.read_distances(width, height);
    std::vector<float> values;
    values.reserve(bottom_up.size());
    for (int y = height - 1; y >= 0; --y) {
        const auto row = bottom_up.begin() + static_cast<std::ptrdiff_t>(y) * width;
        values.insert(values.end(), row, row + width);
    }
    return values;
}

}  // namespace talus::render

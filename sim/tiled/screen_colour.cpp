#include "sim/tiled/screen_colour.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace talus {
namespace {

// Finer than the steps of dark colours, of which one is 1/3295 of all light.
constexpr int light_steps = 16384;

std::array<float, 256> lights() {
    std::array<float, 256> table{};
    for (int i = 0; i < 256; ++i) {
        const float share = static_cast<float>(i) / 255.0F;
        table[static_cast<std::size_t>(i)] =
            share <= 0.04045F ? share / 12.92F : std::pow((share + 0.055F) / 1.055F, 2.4F);
    }
    return table;
}

std::array<std::uint8_t, light_steps + 1> colours() {
    std::array<std::uint8_t, light_steps + 1> table{};
    for (int i = 0; i <= light_steps; ++i) {
        const float light = static_cast<float>(i) / light_steps;
        const float share =
            light <= 0.0031308F ? 12.92F * light : 1.055F * std::pow(light, 1 / 2.4F) - 0.055F;
        table[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(std::lround(255 * share));
    }
    return table;
}

}  // namespace

float from_screen(std::uint8_t colour) {
    static const std::array<float, 256> table = lights();
    return table[colour];
}

std::uint8_t to_screen(float light) {
    static const std::array<std::uint8_t, light_steps + 1> table = colours();
    const float at = std::clamp(light, 0.0F, 1.0F) * light_steps + 0.5F;
    return table[static_cast<std::size_t>(at)];
}

}  // namespace talus

#include "render/grain.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace talus::render {
namespace {

constexpr int grain_side = 512;

double lattice(int x, int y, int period, std::uint32_t seed) {
    const auto wrapped = [&](int v) { return static_cast<std::uint32_t>((v % period + period) % period); };
    std::uint32_t n = wrapped(x) * 1597334677U ^ wrapped(y) * 3812015801U ^ seed * 2654435761U;
    n = (n ^ (n >> 15U)) * 2246822519U;
    n = (n ^ (n >> 13U)) * 3266489917U;
    return static_cast<double>((n >> 8U) & 0xffffU) / 65535.0;
}

// Value noise on a lattice of so many cells a side of the texture, at u and v from 0 to 1.
double noise(double u, double v, int cells, std::uint32_t seed) {
    const double x = u * cells;
    const double y = v * cells;
    const int x0 = static_cast<int>(std::floor(x));
    const int y0 = static_cast<int>(std::floor(y));
    const auto smooth = [](double t) { return t * t * (3 - 2 * t); };
    const double wx = smooth(x - x0);
    const double wy = smooth(y - y0);
    const double a = std::lerp(lattice(x0, y0, cells, seed), lattice(x0 + 1, y0, cells, seed), wx);
    const double b = std::lerp(lattice(x0, y0 + 1, cells, seed), lattice(x0 + 1, y0 + 1, cells, seed), wx);
    return std::lerp(a, b, wy);
}

}  // namespace

gpu::Texture grain_texture() {
    constexpr std::array<int, 4> cells = {18, 71, 150, 211};
    std::vector<std::uint8_t> texels;
    texels.reserve(std::size_t{4} * grain_side * grain_side);
    for (int y = 0; y < grain_side; ++y)
        for (int x = 0; x < grain_side; ++x)
            for (std::uint32_t channel = 0; channel < 4; ++channel) {
                const double u = (x + 0.5) / grain_side;
                const double v = (y + 0.5) / grain_side;
                const int base = cells[channel];
                const double value =
                    0.65 * noise(u, v, base, channel) + 0.35 * noise(u, v, 2 * base + 1, channel + 8);
                texels.push_back(static_cast<std::uint8_t>(std::lround(255 * value)));
            }
    gpu::Texture texture("grain", gpu::Format::rgba8, grain_side, grain_side, 10);
    texture.write(texture.whole(), std::as_bytes(std::span(texels)));
    texture.filter(gpu::Wrap::repeat);
    return texture;
}

}  // namespace talus::render

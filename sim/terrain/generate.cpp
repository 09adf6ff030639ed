#include "sim/terrain/generate.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <thread>

#include "sim/gpu/error.h"

namespace talus {
namespace {

// A well-mixed hash of a lattice point (Jarzynski & Olano 2020, "Hash functions for GPU rendering", pcg3d).
std::uint32_t hash(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    x = x * 1664525U + 1013904223U;
    y = y * 1664525U + 1013904223U;
    z = z * 1664525U + 1013904223U;
    x += y * z;
    y += z * x;
    z += x * y;
    x ^= x >> 16U;
    y ^= y >> 16U;
    z ^= z >> 16U;
    x += y * z;
    y += z * x;
    z += x * y;
    return z ^ (x >> 3U);
}

double lattice(std::int64_t x, std::int64_t y, std::uint32_t seed) {
    return hash(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), seed) * (2.0 / 4294967295.0) -
           1.0;
}

struct Noise {
    double value;      // about -1 to 1
    glm::dvec2 slope;  // its derivative
};

// Value noise with a quintic blend, and its exact derivative.
Noise noise(glm::dvec2 p, std::uint32_t seed) {
    const glm::dvec2 cell(std::floor(p.x), std::floor(p.y));
    const glm::dvec2 f = p - cell;
    const auto x = static_cast<std::int64_t>(cell.x);
    const auto y = static_cast<std::int64_t>(cell.y);
    const auto blend = [](double t) { return t * t * t * (t * (t * 6 - 15) + 10); };
    const auto blend_slope = [](double t) { return 30 * t * t * (t * (t - 2) + 1); };
    const double a = lattice(x, y, seed);
    const double b = lattice(x + 1, y, seed);
    const double c = lattice(x, y + 1, seed);
    const double d = lattice(x + 1, y + 1, seed);
    const double u = blend(f.x);
    const double v = blend(f.y);
    const double k = a - b - c + d;
    return {a + u * (b - a) + v * (c - a) + k * u * v,
            {blend_slope(f.x) * ((b - a) + k * v), blend_slope(f.y) * ((c - a) + k * u)}};
}

// Octaves turn by atan(3/4), so that the lattice shows in none of the directions.
glm::dvec2 turn(glm::dvec2 p) {
    return {0.8 * p.x - 0.6 * p.y, 0.6 * p.x + 0.8 * p.y};
}

// p in units of the terrain's larger extent.
double hills(glm::dvec2 p, std::uint32_t seed) {
    double sum = 0;
    double weight = 1;
    p = 3.0 * p;
    for (std::uint32_t octave = 0; octave < 10; ++octave) {
        sum += weight * noise(p, seed + octave).value;
        weight *= 0.47;
        p = 2.03 * turn(p) + glm::dvec2(17.1, 9.7);
    }
    return sum;
}

// Ridges where noise crosses zero; each octave counts less where the coarser ones are steep or low, so crests
// stay sharp, flanks are cut by ravines and valley floors are calm (after Musgrave's ridged multifractal).
double mountains(glm::dvec2 p, std::uint32_t seed) {
    const glm::dvec2 warp(noise(2.1 * p + glm::dvec2(5.2, 1.3), seed + 101).value,
                          noise(2.1 * p + glm::dvec2(1.7, 9.2), seed + 102).value);
    const double massif = 0.5 + 0.5 * noise(1.9 * p + glm::dvec2(3.3, 7.7), seed + 103).value;
    glm::dvec2 q = 3.1 * (p + 0.09 * warp);
    double sum = 0;
    double weight = 1;
    double amplitude = 1;
    glm::dvec2 slope(0);
    for (std::uint32_t octave = 0; octave < 11; ++octave) {
        const Noise n = noise(q, seed + octave);
        const double ridge = 1 - std::sqrt(n.value * n.value + 0.0009 * amplitude);
        slope += amplitude * n.slope;
        const double damping = 1 / (1 + 0.12 * glm::dot(slope, slope));
        const double sharp = octave < 4 ? ridge * ridge : 0.5 + 0.5 * n.value;
        sum += amplitude * weight * damping * sharp;
        weight = std::clamp(weight * (0.25 + 1.1 * ridge), 0.0, 1.0);
        amplitude *= 0.48;
        q = 2.02 * turn(q) + glm::dvec2(31.4, 27.2);
    }
    return sum * (0.35 + massif);
}

}  // namespace

const std::vector<std::string>& generator_kinds() {
    static const std::vector<std::string> kinds = {"mountains", "hills", "flat"};
    return kinds;
}

std::vector<float> generate_heights(const Grid& grid, const GeneratorSettings& settings) {
    check_grid(grid);
    std::vector<float> heights(grid.count(), 0.0F);
    if (settings.kind == "flat") return heights;
    const double extent = std::max(grid.width_m(), grid.height_m());
    std::vector<double> raw(grid.count());
    // Rows are independent, so threads change nothing but the time.
    const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    {
        std::vector<std::jthread> workers;
        for (int t = 0; t < threads; ++t)
            workers.emplace_back([&, t] {
                for (int row = t; row < grid.ny; row += threads)
                    for (int column = 0; column < grid.nx; ++column) {
                        const glm::dvec2 p(column * grid.dx / extent, (grid.ny - 1 - row) * grid.dy / extent);
                        raw[static_cast<std::size_t>(row) * grid.nx + column] =
                            settings.kind == "hills" ? hills(p, settings.seed) : mountains(p, settings.seed);
                    }
            });
    }
    const auto [lowest, highest] = std::minmax_element(raw.begin(), raw.end());
    const double low = *lowest;
    const double high = *highest;
    const double scale = high > low ? settings.relief_m / (high - low) : 0;
    std::transform(raw.begin(), raw.end(), heights.begin(),
                   [&](double h) { return static_cast<float>((h - low) * scale); });
    return heights;
}

}  // namespace talus

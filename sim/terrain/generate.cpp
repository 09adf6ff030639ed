#include "sim/terrain/generate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <iterator>
#include <limits>
#include <thread>

#include "sim/error.h"
#include "sim/terrain/plane_noise.h"

namespace talus {
namespace {

double noise(glm::dvec2 p, std::uint32_t seed) {
    return plane_noise(p, seed);
}

// Shapes take p in units of the terrain's larger extent, and so many octaves more than a terrain has that is
// held as a whole.
double hills(glm::dvec2 p, std::uint32_t seed, int more) {
    return fbm(3.0 * p, seed, 10 + more, 0.47);
}

// Ridged multifractal (Musgrave, in Ebert et al. 2003, "Texturing and Modeling", chapter 16): ridges where
// noise crosses zero, each octave weighted by the one before, so crests are rough and valley floors calm. Its
// domain is warped so that ridges wind, and a broad swell sets ranges apart from lowland.
double mountains(glm::dvec2 p, std::uint32_t seed, int more) {
    const glm::dvec2 warp(fbm(2.3 * p + glm::dvec2(5.2, 1.3), seed + 101, 4, 0.5),
                          fbm(2.3 * p + glm::dvec2(1.7, 9.2), seed + 131, 4, 0.5));
    glm::dvec2 q = 2.6 * (p + 0.10 * warp);
    const double swell =
        std::clamp(0.62 + 1.1 * noise(1.35 * p + 0.15 * warp + glm::dvec2(3.3, 7.7), seed + 163), 0.0, 1.0);
    double sum = 0;
    double weight = 1;
    double amplitude = 1;
    for (std::uint32_t octave = 0; octave < 11U + static_cast<std::uint32_t>(more); ++octave) {
        const double n = 1.35 * noise(q, seed + octave);
        double ridge = 1 - std::sqrt(n * n + 0.0004);
        ridge *= ridge;
        sum += amplitude * weight * ridge;
        weight = std::clamp(1.7 * ridge * weight, 0.0, 1.0);
        amplitude *= 0.46;
        q = 2.07 * turned_lattice(q) + glm::dvec2(31.4, 27.2);
    }
    const double ground = 0.12 * fbm(5.0 * p, seed + 201, 8 + more, 0.5);
    return sum * (0.30 + 0.70 * swell * swell * (3 - 2 * swell)) + ground;
}

// 0 to 1, flat at both ends.
double smooth(double t) {
    const double s = std::clamp(t, 0.0, 1.0);
    return s * s * (3 - 2 * s);
}

// A shelf that rises gently from the west, a bay and a headland, a beach, dunes and hills behind.
double coast(glm::dvec2 p, std::uint32_t seed, int more) {
    const double shore =
        0.55 + 0.16 * noise(glm::dvec2(1.7, 2.4 * p.y), seed) + 0.05 * fbm(6.0 * p, seed + 17, 4, 0.5);
    const double inland = p.x - shore;
    const double shelf = 0.45 + 0.7 * std::max(inland, -0.6);
    const double hills_height =
        0.9 * smooth((inland - 0.02) / 0.4) * (0.55 + fbm(4.0 * p, seed + 31, 9 + more, 0.5));
    return shelf + std::max(hills_height, 0.0) + 0.012 * fbm(20.0 * p, seed + 61, 5, 0.5);
}

// One mountain, a little out of the middle, with ridges and bays, on a shelf.
double island(glm::dvec2 p, std::uint32_t seed, int more) {
    const glm::dvec2 q = p - glm::dvec2(0.54, 0.5) +
                         0.05 * glm::dvec2(fbm(4.0 * p, seed, 5, 0.5), fbm(4.0 * p, seed + 9, 5, 0.5));
    const double r = std::sqrt(q.x * q.x + q.y * q.y);
    const double cone = std::max(0.0, 1 - r / 0.24);
    return 0.9 * cone * cone + 0.35 * smooth(1.25 - r / 0.28) +
           cone * 0.35 * fbm(7.0 * p, seed + 21, 8 + more, 0.5) + 0.01 * fbm(12.0 * p, seed + 41, 6, 0.5);
}

// A valley that winds and falls eastwards between hills.
double valley(glm::dvec2 p, std::uint32_t seed, int more) {
    const double middle = 0.5 + 0.16 * noise(glm::dvec2(2.6 * p.x, 0.3), seed) +
                          0.05 * noise(glm::dvec2(6.0 * p.x, 4.7), seed + 3);
    const double across = std::abs(p.y - middle);
    const double flank = smooth((across - 0.03) / 0.30);
    return 0.25 * (1 - p.x) + flank * (0.75 + 0.5 * fbm(4.0 * p, seed + 11, 9 + more, 0.5)) +
           0.01 * fbm(18.0 * p, seed + 51, 5, 0.5);
}

double bowl(glm::dvec2 p, std::uint32_t, int) {
    const glm::dvec2 q = p - glm::dvec2(0.5);
    return q.x * q.x + q.y * q.y;
}

// A smooth upland that no water has cut yet, on a plain that drains it outwards.
double massif(glm::dvec2 p, std::uint32_t seed, int) {
    const glm::dvec2 warp(fbm(2.2 * p + glm::dvec2(5.2, 1.3), seed + 7, 3, 0.5),
                          fbm(2.2 * p + glm::dvec2(1.7, 9.2), seed + 19, 3, 0.5));
    const glm::dvec2 q = p - glm::dvec2(0.5) + 0.16 * warp;
    const double r = std::sqrt(q.x * q.x + q.y * q.y);
    const double upland = smooth((0.46 - r) / 0.40);
    return upland * (0.85 + 0.35 * fbm(3.1 * p, seed + 31, 4, 0.45)) - 0.16 * r +
           0.010 * fbm(22.0 * p, seed + 61, 4, 0.6);
}

// A table that falls gently eastwards to its escarpment, with the course of a river, a plain before it.
double plateau(glm::dvec2 p, std::uint32_t seed, int) {
    const double edge =
        0.74 + 0.07 * noise(glm::dvec2(2.1, 4.0 * p.y), seed) + 0.02 * fbm(9.0 * p, seed + 5, 4, 0.5);
    const double middle = 0.5 + 0.13 * noise(glm::dvec2(3.1 * p.x, 0.3), seed + 3) +
                          0.04 * noise(glm::dvec2(8.0 * p.x, 4.7), seed + 9);
    const double across = std::abs(p.y - middle);
    const double table = 0.86 + 0.10 * (1 - p.x) + 0.10 * smooth((across - 0.02) / 0.25) +
                         0.02 * fbm(7.0 * p, seed + 23, 6, 0.5);
    const double plain = 0.10 + 0.08 * (1 - p.x) + 0.01 * fbm(9.0 * p, seed + 41, 5, 0.5);
    const double fall = smooth((edge - p.x) / 0.10);
    return plain + fall * (table - plain);
}

// A flood plain in the west that a gorge gathers, and a lake basin in the east.
double delta(glm::dvec2 p, std::uint32_t seed, int) {
    const double across = std::abs(p.y - 0.5) + 0.02 * noise(6.0 * p, seed);
    const double gate = smooth(1 - std::abs(p.x - 0.11) / 0.10);
    const double walls = (0.10 + 0.9 * gate) * smooth((across - (0.42 - 0.37 * gate)) / 0.10);
    const double shore = 0.22 + 0.03 * noise(glm::dvec2(3.0 * p.y, 1.1), seed + 3);
    const double basin = smooth((p.x - shore) / 0.22);
    return 0.62 - 0.16 * p.x - 0.40 * basin + 0.5 * walls * (1 - smooth((p.x - 0.17) / 0.07)) +
           0.006 * fbm(18.0 * p, seed + 51, 5, 0.5);
}

// Many parallel narrow ridges and valleys, as a spectrogram has: lines of constant frequency from west to
// east, each of a loudness of its own that changes on the way, and hiss between them (the kind of terrain SP
// of Ammann, Genevaux & Dischler 2010, figure 3).
double spectrogram(glm::dvec2 p, std::uint32_t seed, int) {
    constexpr double lines = 120;
    const double at = p.y * lines;
    const double line = std::floor(at);
    const double aside = std::abs(2 * (at - line) - 1);
    const double loudness =
        std::clamp(0.5 + 1.2 * noise(glm::dvec2(7.0 * p.x, 13.7 * line + 0.5), seed), 0.0, 1.0);
    const double voice =
        std::clamp(0.55 + 1.1 * fbm(glm::dvec2(3.0 * p.x, 5.0 * p.y), seed + 11, 4, 0.5), 0.0, 1.0);
    const double ridge = 1 - aside;
    return voice * (loudness * ridge * ridge + 0.12 * fbm(260.0 * p, seed + 31, 4, 0.8)) +
           0.08 * fbm(6.0 * p, seed + 61, 4, 0.5);
}

// Horns and deep valleys between them: silhouettes from every side, also from above (the kind HA of the same
// figure).
double high_amplitude(glm::dvec2 p, std::uint32_t seed, int) {
    const double n = 1.3 * fbm(5.0 * p, seed, 3, 0.4);
    const double ridge = std::max(0.0, 1 - std::sqrt(n * n + 0.0001));
    const double horn = ridge * ridge * ridge * ridge;
    const double swell = std::clamp(0.5 + 1.2 * noise(3.0 * p + glm::dvec2(2.2, 8.1), seed + 43), 0.0, 1.0);
    return horn * (0.25 + 0.75 * swell) + 0.04 * fbm(24.0 * p, seed + 71, 6, 0.5);
}

struct Shape {
    const char* kind;
    double (*height)(glm::dvec2, std::uint32_t, int more);  // null: 0 everywhere
    bool seeded = true;
};

constexpr Shape shapes[] = {{"mountains", mountains},     {"hills", hills},
                            {"flat", nullptr, false},     {"coast", coast},
                            {"island", island},           {"valley", valley},
                            {"bowl", bowl, false},        {"massif", massif},
                            {"plateau", plateau},         {"delta", delta},
                            {"spectrogram", spectrogram}, {"high_amplitude", high_amplitude}};

const Shape* shape_of(const std::string& kind) {
    const auto* const found =
        std::find_if(std::begin(shapes), std::end(shapes), [&](const Shape& s) { return s.kind == kind; });
    if (found == std::end(shapes))
        throw Error(fmt::format("terrain.kind '{}' is none, it must be one of: {}", kind,
                                fmt::join(generator_kinds(), ", ")));
    return found;
}

// Places of a terrain of any size that its range of heights is taken from.
constexpr int range_samples = 257;

}  // namespace

const std::vector<std::string>& generator_kinds() {
    static const std::vector<std::string> kinds = [] {
        std::vector<std::string> names;
        for (const Shape& shape : shapes) names.emplace_back(shape.kind);
        return names;
    }();
    return kinds;
}

bool has_seed(const std::string& kind) {
    return shape_of(kind)->seeded;
}

bool has_relief(const std::string& kind) {
    return shape_of(kind)->height != nullptr;
}

const std::vector<std::string>& starting_waters() {
    static const std::vector<std::string> waters = {"none", "dam", "bowl", "wave", "cloudburst"};
    return waters;
}

std::vector<glm::vec4> generate_water(const Grid& grid, const std::vector<float>& heights,
                                      const StartingWater& water) {
    if (water.kind == "none") return {};
    std::vector<glm::vec4> samples(grid.count(), glm::vec4(0));
    // Thacker's A for a shore at 0.8 of the bowl's radius; the bowl's relief is 8 of its depths (to the
    // corners).
    constexpr double shore = 0.8;
    constexpr double A = (1 - shore * shore) / (1 + shore * shore);
    const double a = grid.width_m() / 4;
    const double h_0 = water.relief_m / 8;
    for (int row = 0; row < grid.ny; ++row)
        for (int column = 0; column < grid.nx; ++column) {
            const std::size_t at = static_cast<std::size_t>(row) * grid.nx + column;
            double depth = 0;
            double speed = 0;
            if (water.kind == "dam") {
                if (3 * column < grid.nx) depth = 0.6 * water.relief_m - heights[at];
            } else if (water.kind == "cloudburst") {
                depth = 0.25;
            } else if (water.kind == "wave") {
                // A hump with the velocity of a simple wave, u = 2 (c - c0): it runs eastwards alone.
                const double still = water.sea_level_m - heights[at];
                const double s = (column * grid.dx - grid.width_m() / 6) / (grid.width_m() / 28);
                const double hump = std::max(0.0, 1 - s * s);
                depth = still + (still > 0 ? water.wave_height_m * hump * hump : 0);
                if (still > 0)
                    speed = 2 * (std::sqrt(water.gravity_m_per_s2 * std::max(0.0, depth)) -
                                 std::sqrt(water.gravity_m_per_s2 * still));
            } else {
                const double x = column * grid.dx - grid.width_m() / 2;
                const double y = row * grid.dy - grid.height_m() / 2;
                const double D = 1 - A;
                depth = h_0 * (std::sqrt(1 - A * A) / D - (x * x + y * y) / (a * a) * (1 - A * A) / (D * D));
            }
            samples[at].x = static_cast<float>(std::max(depth, 0.0));
            samples[at].z = static_cast<float>(samples[at].x * speed);
        }
    return samples;
}

std::vector<float> generate_heights(const Grid& grid, const GeneratorSettings& settings) {
    check_grid(grid);
    std::vector<float> heights(grid.count(), 0.0F);
    const Shape* const found = shape_of(settings.kind);
    if (!found->height) return heights;
    const double extent = std::max(grid.width_m(), grid.height_m());
    std::vector<double> raw(grid.count());
    // Rows are independent, so threads change nothing but the time.
    const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    {
        std::vector<std::jthread> workers;
        workers.reserve(static_cast<std::size_t>(threads));
        for (int t = 0; t < threads; ++t)
            workers.emplace_back([&, t] {
                for (int row = t; row < grid.ny; row += threads)
                    for (int column = 0; column < grid.nx; ++column) {
                        const glm::dvec2 p(column * grid.dx / extent, (grid.ny - 1 - row) * grid.dy / extent);
                        raw[static_cast<std::size_t>(row) * grid.nx + column] =
                            found->height(p, settings.seed, 0);
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

std::function<float(int column, int row)> generate_sample_by_sample(const Grid& grid,
                                                                    const GeneratorSettings& settings) {
    const Shape* const shape = shape_of(settings.kind);
    if (!shape->height) return [](int, int) { return 0.0F; };
    const double extent = std::max(grid.width_m(), grid.height_m());
    // An octave has 2.05 times the waves of the one before.
    const double doublings = std::log2(std::max(grid.nx, grid.ny) / static_cast<double>(max_samples));
    const int more = std::max(0, static_cast<int>(std::ceil(doublings / std::log2(2.05))));
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (int i = 0; i < range_samples * range_samples; ++i) {
        const glm::dvec2 share = glm::dvec2(i % range_samples, i / range_samples) / (range_samples - 1.0);
        const double height =
            shape->height(share * glm::dvec2(grid.width_m(), grid.height_m()) / extent, settings.seed, more);
        low = std::min(low, height);
        high = std::max(high, height);
    }
    const double scale = high > low ? settings.relief_m / (high - low) : 0;
    return [=, seed = settings.seed](int column, int row) {
        const glm::dvec2 p(column * grid.dx / extent, (grid.ny - 1 - row) * grid.dy / extent);
        return static_cast<float>((shape->height(p, seed, more) - low) * scale);
    };
}

}  // namespace talus

#include "sim/terrain/stamp_shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/error.h"
#include "sim/terrain/plane_noise.h"

namespace talus {
namespace {

double eased(double from, double to, double value) {
    const double s = std::clamp((value - from) / (to - from), 0.0, 1.0);
    return s * s * (3 - 2 * s);
}

// From the middle, and not quite a circle.
double distance_of(glm::dvec2 place, double unevenness, std::uint32_t seed, int octaves = 4) {
    return glm::length(place) * (1 + unevenness * fbm(2.0 * place, seed, octaves, 0.5));
}

// 1 within, 0 on the border.
double within(glm::dvec2 place) {
    return 1 - eased(0.8, 0.99, glm::length(place));
}

// Where the rim stands, and how high beside the ground around it.
constexpr double rim = 0.45;
constexpr double rim_height = 0.036 * 2 * rim;

// What was thrown out falls off with the third power of the distance (McGetchin et al. 1973).
double ejecta(double r) {
    const double share = rim / r;
    return rim_height * share * share * share;
}

// Simple craters: 0.196 of the diameter deep from the rim, the rim 0.036 high (Pike 1977).
double crater(glm::dvec2 place) {
    const double r = distance_of(place, 0.08, 11);
    constexpr double depth = 0.196 * 2 * rim;
    const double inside = rim_height - depth * (1 - (r / rim) * (r / rim));
    return (r < rim ? inside : ejecta(r)) * within(place);
}

// Complex ones: shallower, a flat floor, walls that slumped into terraces, a peak in the middle (Pike 1985).
double peaked_crater(glm::dvec2 place) {
    const double r = distance_of(place, 0.12, 23);
    if (r >= rim) return ejecta(r) * within(place);
    constexpr double depth = 0.1 * 2 * rim;
    const double wall = eased(0.55 * rim, rim, r);
    const double terraces = 0.12 * wall * (1 - wall) * (1 + fbm(6.0 * place, 41, 3, 0.5));
    const double peak = 0.55 * depth * (1 - eased(0, 0.26 * rim, distance_of(place, 0.5, 31)));
    const double rough = 0.05 * depth * fbm(9.0 * place, 51, 4, 0.5);
    return rim_height - depth * (1 - wall + terraces) + peak + rough * (1 - wall);
}

// A cone that steepens upwards, its flanks furrowed, with a crater.
double volcano(glm::dvec2 place) {
    const double r = distance_of(place, 0.06, 61);
    const auto flank = [](double at) {
        const double rest = std::max(0.0, 1 - at);
        return 0.62 * rest * rest / (1 + 0.6 * at);
    };
    constexpr double mouth = 0.11;
    const double furrows = 0.06 * fbm(7.0 * place, 71, 5, 0.55) * r * std::max(0.0, 1 - r);
    if (r >= mouth) return (flank(r) + furrows) * within(place);
    return flank(mouth) + furrows - 0.09 * (1 - (r / mouth) * (r / mouth));
}

// A table with cliffs, and talus at their foot.
double mesa(glm::dvec2 place) {
    const double r = distance_of(place, 0.35, 81, 2);
    const double table = 0.30 + 0.008 * fbm(5.0 * place, 91, 4, 0.5);
    const double cliff = 1 - eased(0.46, 0.61, r);
    const double rest = std::max(0.0, 1 - std::max(0.0, r - 0.54) / 0.34);
    return (cliff * 0.55 * table + 0.45 * table * rest * (0.4 + 0.6 * rest)) * within(place);
}

// Transverse dunes of a wind from the west: long backs, short lees at 32 degrees.
double dunes(glm::dvec2 place) {
    constexpr double wavelength = 0.25;
    constexpr double lee_share = 0.22;
    constexpr double lee_slope = 0.62;
    const double phase = (place.x + 0.11 * fbm(1.7 * place, 101, 3, 0.5)) / wavelength;
    const double along = phase - std::floor(phase);
    const double back = eased(0, 1, along / (1 - lee_share));
    const double lee = (1 - along) / lee_share;
    const double height = wavelength * lee_share * lee_slope * (0.75 + 0.35 * fbm(2.3 * place, 111, 3, 0.5));
    return height * std::min(back, std::min(lee, 1.0)) * within(place);
}

}  // namespace

const std::vector<StampShape>& stamp_shapes() {
    static const std::vector<StampShape> all = {
        {"crater", "a bowl with a rim, and what was thrown out around it", crater},
        {"peaked_crater", "a large crater: flat floor, terraces, a peak in the middle", peaked_crater},
        {"volcano", "a furrowed cone with a crater", volcano},
        {"mesa", "a table with cliffs and talus at their foot", mesa},
        {"dunes", "transverse dunes, wind from the west", dunes}};
    return all;
}

Stamp shaped_stamp(const std::string& name) {
    const auto found = std::find_if(stamp_shapes().begin(), stamp_shapes().end(),
                                    [&](const StampShape& one) { return one.name == name; });
    if (found == stamp_shapes().end()) throw Error(fmt::format("there is no stamp '{}' on the shelf", name));
    constexpr int samples = 257;
    constexpr double width_m = 1000;
    const Grid grid{samples, samples, width_m / (samples - 1), width_m / (samples - 1)};
    std::vector<float> heights_m;
    heights_m.reserve(grid.count());
    for (int y = 0; y < samples; ++y)
        for (int x = 0; x < samples; ++x) {
            const glm::dvec2 place(2.0 * x / (samples - 1) - 1, 1 - 2.0 * y / (samples - 1));
            heights_m.push_back(static_cast<float>(width_m / 2 * found->height(place)));
        }
    Stamp stamp = stamp_of(grid, heights_m);
    stamp.in_proportion = true;
    return stamp;
}

}  // namespace talus

#include "app/core/small_picture.h"

#include <algorithm>
#include <cmath>

#include "app/core/bilinear.h"

namespace talus::app {

glm::ivec2 small_picture_size(const Grid& grid) {
    constexpr double side = 320;
    const glm::dvec2 extent(grid.width_m(), grid.height_m());
    return glm::max(glm::ivec2(extent * (side / std::max(extent.x, extent.y))), 2);
}

std::vector<std::uint8_t> small_picture(const Grid& grid, const std::vector<float>& heights_m,
                                        const std::vector<float>& depths_m, glm::ivec2 size) {
    const auto [low, high] = std::minmax_element(heights_m.begin(), heights_m.end());
    const double relief = std::max(1e-6, static_cast<double>(*high) - *low);
    const glm::dvec2 step = glm::dvec2(grid.nx - 1, grid.ny - 1) / glm::dvec2(glm::max(size - 1, 1));
    const glm::ivec2 count(grid.nx, grid.ny);
    const auto between = [&](const std::vector<float>& values, glm::dvec2 place) {
        return bilinear(place, count, [&](int column, int row) {
            return static_cast<double>(values[static_cast<std::size_t>(row) * grid.nx + column]);
        });
    };
    // Slopes between places as far apart as pixels, at least as samples.
    const glm::dvec2 reach = glm::max(step, glm::dvec2(1));
    const glm::dvec3 sun = glm::normalize(glm::dvec3(-1, 1, 1.2));
    std::vector<std::uint8_t> rgba;
    const auto put = [&](glm::dvec3 colour) {
        for (const double part : {colour.r, colour.g, colour.b})
            rgba.push_back(static_cast<std::uint8_t>(255 * std::clamp(part, 0.0, 1.0)));
        rgba.push_back(255);
    };
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const glm::dvec2 place = glm::dvec2(x, y) * step;
            const glm::dvec2 low_place = glm::max(place - reach, glm::dvec2(0));
            const glm::dvec2 high_place = glm::min(place + reach, glm::dvec2(count - 1));
            const glm::dvec2 apart_m = (high_place - low_place) * glm::dvec2(grid.dx, grid.dy);
            const glm::dvec2 slope(
                (between(heights_m, {high_place.x, place.y}) - between(heights_m, {low_place.x, place.y})) /
                    apart_m.x,
                (between(heights_m, {place.x, low_place.y}) - between(heights_m, {place.x, high_place.y})) /
                    apart_m.y);
            const double light = std::max(0.0, glm::dot(glm::normalize(glm::dvec3(-slope, 1)), sun));
            const double share = (between(heights_m, place) - *low) / relief;
            const glm::dvec3 ground =
                1.15 * light * (glm::dvec3(0.55, 0.60, 0.50) + share * glm::dvec3(0.45, 0.35, 0.45));
            const double depth_m = depths_m.empty() ? 0 : between(depths_m, place);
            // The ground shows through what is shallow.
            const double clear = std::exp(-6 * depth_m / relief);
            const glm::dvec3 water =
                glm::mix(glm::dvec3(0.08, 0.22, 0.38), glm::dvec3(0.35, 0.62, 0.72), clear);
            put(depth_m > 0 ? glm::mix(water, ground, 0.6 * clear * clear) : ground);
        }
    return rgba;
}

}  // namespace talus::app

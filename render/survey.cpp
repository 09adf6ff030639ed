#include "render/survey.h"

#include <algorithm>
#include <cmath>

namespace talus::render {

std::vector<NamedCamera> survey(const Grid& grid, const std::vector<float>& heights) {
    const double w = grid.width_m();
    const double h = grid.height_m();
    const double extent = std::max(w, h);
    const auto [low_it, high_it] = std::minmax_element(heights.begin(), heights.end());
    const double low = *low_it;
    const double high = *high_it;
    const auto ground = [&](double x, double y) {
        const int column = static_cast<int>(std::lround(grid.column_of(x)));
        const int row = static_cast<int>(std::lround(grid.row_of(y)));
        return static_cast<double>(heights[static_cast<std::size_t>(row) * grid.nx + column]);
    };
    const auto lowest = static_cast<int>(low_it - heights.begin());
    const int lowest_row = lowest / grid.nx;
    const glm::dvec3 valley(lowest % grid.nx * grid.dx, (grid.ny - 1 - lowest_row) * grid.dy, low + 2);
    const glm::dvec3 middle(0.5 * w, 0.5 * h, ground(0.5 * w, 0.5 * h));
    const auto pitched = [&](double deg) {
        const double a = deg * 3.14159265358979 / 180;
        const glm::dvec3 eye(0.31 * w, 0.17 * h, high + 0.05 * extent);
        return Camera{eye, eye + glm::dvec3(0.3 * std::cos(a), 0.954 * std::cos(a), -std::sin(a)), 55};
    };
    const glm::dvec3 over(0.37 * w, 0.41 * h, high + 0.4 * extent);
    return {
        {"level", pitched(0)},
        {"-30 degrees", pitched(30)},
        {"-60 degrees", pitched(60)},
        {"straight down", {over, over - glm::dvec3(0, 0, 1), 60}},
        {"valley looking up",
         {valley, valley + glm::dvec3(0.5 * w - valley.x, 0.5 * h - valley.y, 0.3 * extent), 70}},
        {"below ground", {middle - glm::dvec3(0, 0, 30), middle + glm::dvec3(100, 30, -30), 60}},
        {"along an axis",
         {{-0.1 * w, 0.5 * h, high * 0.7 + low * 0.3}, {w, 0.5 * h, high * 0.7 + low * 0.3}, 40}},
        {"along a diagonal", {{-0.05 * w, -0.05 * h, high}, {w, h, low}, 50}},
        {"walking", {middle + glm::dvec3(0, 0, 2), middle + glm::dvec3(1, 0.4, 2.05), 60}},
        {"through the side", {{0.4 * w, -0.3 * h, 0.5 * (low + high)}, {0.5 * w, h, low - 0.2 * extent}, 50}},
        {"far away", {{-9 * w, -7 * h, high + 2 * extent}, middle, 6}},
        {"from below the sky", {{0.6 * w, 0.6 * h, low - 0.5 * extent}, {0.1 * w, 0.1 * h, high}, 60}},
    };
}

}  // namespace talus::render

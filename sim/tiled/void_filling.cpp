#include "sim/tiled/void_filling.h"

#include <algorithm>
#include <limits>

namespace talus {
namespace {

// Of the known ones of 2 x 2 samples the mean.
std::vector<float> halved(const std::vector<float>& heights, glm::ivec2 size, glm::ivec2 half) {
    std::vector<float> means;
    means.reserve(static_cast<std::size_t>(half.x) * half.y);
    for (int y = 0; y < half.y; ++y)
        for (int x = 0; x < half.x; ++x) {
            double sum = 0;
            double known = 0;
            for (int row = 2 * y; row < std::min(2 * y + 2, size.y); ++row)
                for (int column = 2 * x; column < std::min(2 * x + 2, size.x); ++column) {
                    const float h = heights[static_cast<std::size_t>(row) * size.x + column];
                    if (std::isnan(h)) continue;
                    sum += h;
                    known += 1;
                }
            means.push_back(known > 0 ? static_cast<float>(sum / known)
                                      : std::numeric_limits<float>::quiet_NaN());
        }
    return means;
}

}  // namespace

bool fill_voids_by_means(std::vector<float>& heights, glm::ivec2 size) {
    if (std::none_of(heights.begin(), heights.end(), [](float h) { return std::isnan(h); })) return true;
    if (size == glm::ivec2(1)) return false;
    const glm::ivec2 half = (size + 1) / 2;
    std::vector<float> means = halved(heights, size, half);
    if (!fill_voids_by_means(means, half)) return false;
    fill_voids_from(means, half, heights, size,
                    [](glm::ivec2 sample) { return (glm::dvec2(sample) + 0.5) / 2.0 - 0.5; });
    return true;
}

}  // namespace talus

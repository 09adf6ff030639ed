#pragma once
#include <cmath>
#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

namespace talus {

/// Gives samples of a rectangle that are not known (NaN) the height of another one, bilinear. place_of: where
/// a sample of the one, by column and row, lies among those of the other, which are all known.
template <typename Place>
void fill_voids_from(const std::vector<float>& other, glm::ivec2 other_size, std::vector<float>& heights,
                     glm::ivec2 size, const Place& place_of) {
    std::size_t at = 0;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x, ++at) {
            if (!std::isnan(heights[at])) continue;
            const glm::dvec2 place =
                glm::clamp(place_of(glm::ivec2(x, y)), glm::dvec2(0), glm::dvec2(other_size - 1));
            const glm::ivec2 low = glm::floor(place);
            const glm::ivec2 high = glm::min(low + 1, other_size - 1);
            const glm::dvec2 share = place - glm::dvec2(low);
            const auto sample = [&](int column, int row) -> double {
                return other[static_cast<std::size_t>(row) * other_size.x + column];
            };
            heights[at] = static_cast<float>(
                glm::mix(glm::mix(sample(low.x, low.y), sample(high.x, low.y), share.x),
                         glm::mix(sample(low.x, high.y), sample(high.x, high.y), share.x), share.y));
        }
}

/// Fills voids (NaN) by a pyramid of means of the known ones, down to a single one. False where nothing is
/// known.
bool fill_voids_by_means(std::vector<float>& heights, glm::ivec2 size);

}  // namespace talus

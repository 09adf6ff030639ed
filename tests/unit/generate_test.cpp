// Generated terrain: every kind fills its relief, is another one by another seed, and has the shape that its
// name says.
#include "sim/terrain/generate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/error.h"

namespace talus::generate_test {
namespace {

const Grid grid{513, 257, 4, 4};

TEST(GeneratedTerrain, FillsItsReliefByEverySeed) {
    for (const std::string& kind : generator_kinds()) {
        const std::vector<float> heights = generate_heights(grid, {kind, 3, 250});
        const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
        EXPECT_EQ(*low, 0) << kind;
        if (kind == "flat") continue;
        EXPECT_FLOAT_EQ(*high, 250) << kind;
        EXPECT_EQ(heights, generate_heights(grid, {kind, 3, 250})) << kind;
        if (kind == "bowl") continue;  // there is one
        EXPECT_NE(heights, generate_heights(grid, {kind, 4, 250})) << kind;
    }
}

// Parallel ridges, narrow and steep across: from west to east it changes less than half as fast as from south
// to north.
TEST(GeneratedTerrain, ASpectrogramsRidgesRunOneWay) {
    const std::vector<float> heights = generate_heights(grid, {"spectrogram", 1, 100});
    double along = 0;
    double across = 0;
    for (std::size_t row = 1; row < 257; ++row)
        for (std::size_t column = 1; column < 513; ++column) {
            const float here = heights[row * 513 + column];
            along += std::abs(here - heights[row * 513 + column - 1]);
            across += std::abs(here - heights[(row - 1) * 513 + column]);
        }
    EXPECT_GT(across, 2 * along);
}

// Horns: little of the ground is high, and what is high is steep.
TEST(GeneratedTerrain, HighAmplitudeIsHorns) {
    const std::vector<float> heights = generate_heights(grid, {"high_amplitude", 1, 500});
    const auto high = std::count_if(heights.begin(), heights.end(), [](float h) { return h > 250; });
    EXPECT_GT(high, static_cast<std::ptrdiff_t>(heights.size() / 200));
    EXPECT_LT(high, static_cast<std::ptrdiff_t>(heights.size() / 4));
}

TEST(GeneratedTerrain, OfAnUnknownKindIsRefused) {
    EXPECT_THROW(static_cast<void>(generate_heights(grid, {"moon", 1, 100})), Error);
}

}  // namespace
}  // namespace talus::generate_test

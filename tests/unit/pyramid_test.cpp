// Refreshing only what changed gives the pyramid that a full rebuild gives (law 2).
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <random>

#include "render/pyramid.h"
#include "sim/gpu/context.h"
#include "sim/passes/brush.h"
#include "sim/terrain/generate.h"

namespace talus {
namespace {

bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](float x, float y) {
        return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y);
    });
}

class PyramidSizes : public ::testing::TestWithParam<Grid> {};

TEST_P(PyramidSizes, RefreshAfterRandomDabsEqualsRebuild) {
    const gpu::Context context;
    const Grid grid = GetParam();
    Terrain terrain(bedrock_terrain(grid, generate_heights(grid, {"hills", 1, 300})));
    Pyramid refreshed(terrain);
    refreshed.refresh(terrain);
    Brush brush(terrain);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int i = 0; i < 1000; ++i) {
        Dab dab;
        dab.mode = static_cast<BrushMode>(i % 4);
        dab.x_m = grid.width_m() * (1.1 * unit(random) - 0.05);
        dab.y_m = grid.height_m() * (1.1 * unit(random) - 0.05);
        dab.radius_m = 5 + 200 * unit(random);
        dab.falloff = unit(random);
        dab.amount_m = 40 * unit(random);
        dab.blend = unit(random);
        dab.target_m = 300 * unit(random);
        brush.dab(terrain, dab);
        refreshed.refresh(terrain);
    }
    Pyramid rebuilt(terrain);
    terrain.tiles.mark_all();
    rebuilt.refresh(terrain);
    EXPECT_TRUE(same_bits(refreshed.highest.read_all<float>(), rebuilt.highest.read_all<float>()));
    EXPECT_TRUE(same_bits(refreshed.lowest.read_all<float>(), rebuilt.lowest.read_all<float>()));

    // And a rebuild is right: its last texel bounds the ground.
    const std::vector<float> ground = terrain.ground.read_all<float>();
    EXPECT_EQ(rebuilt.highest.read_all<float>().back(), *std::max_element(ground.begin(), ground.end()));
    EXPECT_EQ(rebuilt.lowest.read_all<float>().back(), *std::min_element(ground.begin(), ground.end()));
}

TEST_P(PyramidSizes, TakesAtMostFourBytesASample) {
    const gpu::Context context;
    const Grid grid = GetParam();
    const Terrain terrain(bedrock_terrain(grid, std::vector<float>(grid.count(), 0.0F)));
    EXPECT_LE(static_cast<double>(Pyramid(terrain).bytes()) / static_cast<double>(grid.count()), 4.0);
}

INSTANTIATE_TEST_SUITE_P(Sizes, PyramidSizes,
                         ::testing::Values(Grid{2, 2, 10, 10}, Grid{66, 64, 3, 3}, Grid{130, 257, 4, 6},
                                           Grid{513, 513, 2, 2}, Grid{700, 1030, 2, 2}));

}  // namespace
}  // namespace talus

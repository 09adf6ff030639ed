// Refreshing only what changed gives the pyramid that a full rebuild gives (law 2).
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "app/claims/picture_agreement.h"
#include "render/pyramid.h"
#include "sim/gpu/context.h"
#include "sim/passes/brush.h"
#include "sim/terrain/generate.h"

namespace talus::pyramid_test {
namespace {

class PyramidSizes : public ::testing::TestWithParam<Grid> {};

TEST_P(PyramidSizes, RefreshAfterRandomDabsEqualsRebuild) {
    const gpu::Context context;
    EXPECT_EQ(claims::pyramid_texels_differing(GetParam(), 1000), 0U);
}

TEST_P(PyramidSizes, TakesAtMostFourBytesASample) {
    const gpu::Context context;
    const Grid grid = GetParam();
    const Terrain terrain(bedrock_terrain(grid, std::vector<float>(grid.count(), 0.0F)));
    EXPECT_LE(static_cast<double>(render::Pyramid(terrain).bytes()) / static_cast<double>(grid.count()), 4.0);
}

INSTANTIATE_TEST_SUITE_P(Sizes, PyramidSizes,
                         ::testing::Values(Grid{2, 2, 10, 10}, Grid{66, 64, 3, 3}, Grid{130, 257, 4, 6},
                                           Grid{513, 513, 2, 2}, Grid{700, 1030, 2, 2}));

}  // namespace
}  // namespace talus::pyramid_test

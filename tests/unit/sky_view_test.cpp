// The share of the sky that the ground sees: kept up to date by tiles, and right where it is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "render/sky_view.h"
#include "sim/gpu/context.h"
#include "sim/passes/brush.h"
#include "sim/terrain/generate.h"

namespace talus::sky_view_test {
namespace {

TEST(SkyView, RefreshAfterDabsEqualsRebuild) {
    const gpu::Context context;
    const Grid grid{700, 449, 20, 25};
    Terrain terrain(bedrock_terrain(grid, generate_heights(grid, {"mountains", 5, 1500})));
    render::Pyramid pyramid(terrain);
    render::SkyView kept(terrain);
    Brush brush(terrain);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int round = 0; round < 20; ++round) {
        for (int i = 0; i < 3; ++i)
            brush.dab(terrain, {effect_of(static_cast<BrushMode>(random() % 2)),
                                grid.width_m() * unit(random), grid.height_m() * unit(random),
                                30 + 300 * unit(random), 1, 400 * unit(random), 0, 0, Material::bedrock});
        pyramid.refresh(terrain);
        kept.refresh(terrain, pyramid);
        render::SkyView fresh(terrain);
        terrain.tiles.mark_all();
        fresh.refresh(terrain, pyramid);
        pyramid.refresh(terrain);
        ASSERT_EQ(kept.share().read_all<float>(), fresh.share().read_all<float>()) << "round " << round;
    }
}

TEST(SkyView, IsRightOnPlainSlopeAndInACone) {
    const gpu::Context context;
    const Grid grid{257, 257, 10, 10};
    const auto share_at_middle = [&](const auto& height_m) {
        std::vector<float> heights;
        for (int row = 0; row < grid.ny; ++row)
            for (int column = 0; column < grid.nx; ++column)
                heights.push_back(static_cast<float>(height_m(10.0 * (column - 130), 10.0 * (row - 130))));
        Terrain terrain(bedrock_terrain(grid, heights));
        render::Pyramid pyramid(terrain);
        pyramid.refresh(terrain);
        render::SkyView sky(terrain);
        sky.refresh(terrain, pyramid);
        const std::vector<float> share = sky.share().read_all<float>();
        EXPECT_GE(*std::min_element(share.begin(), share.end()), 0);
        EXPECT_LE(*std::max_element(share.begin(), share.end()), 1);
        return static_cast<double>(share[static_cast<std::size_t>(32) * sky.share().width() + 32]);
    };
    EXPECT_EQ(share_at_middle([](double, double) { return 100; }), 1);
    // A slope of 1 to the east hides 1 - 1 / (1 + cos^2) eastwards: 1/2 once, 1/3 twice of eight directions.
    // Cells lie on a raster, so slantwise they are not just in the direction asked for.
    EXPECT_NEAR(share_at_middle([](double x, double) { return x; }), (5 + 0.5 + 2 / 1.5) / 8, 0.02);
    // In a cone of 45 degrees all directions lose a half.
    EXPECT_NEAR(share_at_middle([](double x, double y) { return std::hypot(x, y); }), 0.5, 0.05);
}

}  // namespace
}  // namespace talus::sky_view_test

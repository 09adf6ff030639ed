// Contour lines lie where heights cross them, and not all over level ground that has just their height.
#include <gtest/gtest.h>

#include <cmath>

#include "render/renderer.h"
#include "sim/gpu/context.h"

namespace talus::contours_test {
namespace {

// Pixels darker than paper in a view over a shore: sea at 0 m in the south, a slope of 1 to 10 in the north.
TEST(Contours, AreLinesOnSlopesAndNothingOnTheSea) {
    const gpu::Context context;
    const Grid grid{257, 257, 30, 30};
    std::vector<float> heights;
    heights.reserve(grid.count());
    for (int row = 0; row < grid.ny; ++row)
        for (int column = 0; column < grid.nx; ++column)
            heights.push_back(row < 128 ? 3.0F * static_cast<float>(128 - row) : 0.0F);
    Terrain terrain(bedrock_terrain(grid, heights));
    render::Renderer renderer(terrain, 32);
    render::ViewSettings settings;
    settings.view = "contours";
    constexpr int width = 400;
    constexpr int height = 400;
    const glm::dvec2 middle(grid.width_m() / 2, grid.height_m() / 2);
    for (const glm::dvec2 off : {glm::dvec2(0, -1), glm::dvec2(0, -3000)}) {
        renderer.draw(terrain, {{middle + off, 9000}, {middle, 0}, 45}, settings, width, height);
        const std::vector<std::uint8_t> rgb = renderer.read_rgb(width, height);
        const std::vector<float> depth = renderer.read_depth(width, height);
        int inked_sea = 0;
        int inked_slope = 0;
        int sea = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const std::size_t i = static_cast<std::size_t>(y) * width + x;
                if (!std::isfinite(depth[i])) continue;
                const bool inked = rgb[3 * i] < 170;
                // The shore lies across the picture's middle.
                if (y > height / 2 + 4) {
                    ++sea;
                    inked_sea += inked ? 1 : 0;
                } else if (y < height / 2 - 4) {
                    inked_slope += inked ? 1 : 0;
                }
            }
        EXPECT_GT(sea, 10000);
        EXPECT_GT(inked_slope, 300);
        EXPECT_LT(inked_sea, sea / 50);
    }
}

}  // namespace
}  // namespace talus::contours_test

// Far from its corner a terrain is as exact as near to it: the same patch before the same camera gives the
// same distances at both ends of 8192 columns of 30 m.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/hits_target.h"
#include "render/methods/method.h"
#include "sim/gpu/context.h"

namespace talus::wide_terrain_test {
namespace {

constexpr int width = 320;
constexpr int height = 180;

class WideTerrain : public ::testing::TestWithParam<const char*> {};

TEST_P(WideTerrain, IsAsExactAtBothEnds) {
    const gpu::Context context;
    const Grid grid{8192, 192, 30, 30};
    // Repeats every 500 columns, which is no multiple of any cell of the pyramid. Which pixels of a crest
    // hybrid gives to its mesh depends on its cells, within the tolerance: there it repeats as these do.
    const int period = std::string(GetParam()) == "hybrid" ? 512 : 500;
    constexpr int periods = 15;
    std::vector<float> heights(grid.count());
    for (int row = 0; row < grid.ny; ++row)
        for (int column = 0; column < grid.nx; ++column) {
            const double u = 2 * 3.14159265358979 * (column % period) / period;
            heights[static_cast<std::size_t>(row) * grid.nx + column] =
                static_cast<float>(800 + 180 * std::sin(7 * u) + 60 * std::cos(31 * u + 0.2 * row) +
                                   25 * std::sin(90 * u + 0.9 * row));
        }
    Terrain terrain(bedrock_terrain(grid, heights));
    render::Pyramid pyramid(terrain);
    pyramid.refresh(terrain);
    const render::HitsTarget target(width, height);
    const render::Method method = render::method_named(GetParam()).make(render::Detail::kind);
    const auto draw = [&](const render::Camera& camera) {
        method({terrain, pyramid, camera, width, height, 0.5, 8, target.framebuffer()});
        return target.hits().read_all<glm::vec2>();
    };
    for (const double above_m : {40.0, 400.0}) {
        // From a place that no float holds, down to the ground ahead, across and against the columns.
        const glm::dvec3 eye(123.4567 * grid.dx, 71.891 * grid.dy, 1050 + above_m);
        const glm::dvec3 shift(periods * period * grid.dx, 0, 0);
        for (const glm::dvec3 way : {glm::dvec3(400, 700, -600), glm::dvec3(-500, 300, -500)}) {
            const std::vector<glm::vec2> west = draw({eye, eye + way, 50});
            const std::vector<glm::vec2> east = draw({eye + shift, eye + shift + way, 50});
            double largest = 0;
            int hits = 0;
            int kinds = 0;
            for (std::size_t i = 0; i < west.size(); ++i) {
                ASSERT_EQ(std::isfinite(west[i].x), std::isfinite(east[i].x)) << i;
                if (!std::isfinite(west[i].x)) continue;
                ++hits;
                kinds += west[i].y == 1 ? 1 : 0;
                largest = std::max(largest, std::abs(static_cast<double>(west[i].x) / east[i].x - 1));
            }
            std::printf("%s, %.0f m: %d hits, %d by mesh, largest difference %.2g\n", GetParam(), above_m,
                        hits, kinds, largest);
            EXPECT_GT(hits, width * height / 2);
            EXPECT_LE(largest, 1e-6);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(OfMethods, WideTerrain, ::testing::Values("exact", "mesh", "hybrid"),
                         [](const auto& method) { return std::string(method.param); });

}  // namespace
}  // namespace talus::wide_terrain_test

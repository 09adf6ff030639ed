// The first picture of a terrain holds all of it.
#include "render/overview.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/core/flight.h"
#include "render/renderer.h"
#include "sim/gpu/context.h"
#include "sim/terrain/generate.h"

namespace talus::overview_test {
namespace {

const std::vector<Grid> grids = {{2, 2, 1, 1},    {513, 513, 20, 20}, {8192, 2, 5, 5},
                                 {3, 4000, 1, 1}, {1537, 400, 30, 9}, {100, 100, 1, 80}};

// From -1 to 1 across and up: the box that corners of the terrain take in the picture.
struct Extent {
    glm::dvec2 low{1e9};
    glm::dvec2 high{-1e9};
};
Extent extent_of(const Grid& grid, const render::Camera& camera, double aspect, double low_m, double high_m) {
    const render::CameraRays rays = camera_rays(camera, aspect, 1);
    Extent extent;
    for (const double x : {0.0, grid.width_m()})
        for (const double y : {0.0, grid.height_m()})
            for (const double z : {low_m, high_m}) {
                const glm::dvec3 to = glm::dvec3(x, y, z) - camera.eye;
                const double ahead = glm::dot(to, rays.forward);
                EXPECT_GT(ahead, 0) << "behind the eye";
                const glm::dvec2 at(
                    glm::dot(to / ahead - rays.middle, rays.right) / glm::dot(rays.right, rays.right),
                    glm::dot(to / ahead - rays.middle, rays.up) / glm::dot(rays.up, rays.up));
                extent.low = glm::min(extent.low, at);
                extent.high = glm::max(extent.high, at);
            }
    return extent;
}

TEST(Overview, HoldsAllOfTheTerrainForAllSizesAndProportions) {
    for (const Grid& grid : grids)
        for (const double relief_m : {0.0, 100.0, 20000.0})
            for (const double aspect : {16.0 / 9, 1.0, 9.0 / 21, 5.0})
                for (const double fov_deg : {5.0, 50.0, 120.0}) {
                    const render::Camera camera =
                        render::overview(grid, -50, -50 + relief_m, {aspect, fov_deg});
                    EXPECT_EQ(camera.fov_deg, fov_deg);
                    const Extent extent = extent_of(grid, camera, aspect, -50, -50 + relief_m);
                    const glm::dvec2 most = glm::max(-extent.low, extent.high);
                    EXPECT_LE(std::max(most.x, most.y), 0.95)
                        << grid.nx << " x " << grid.ny << ", " << relief_m << " m, " << aspect << ", "
                        << fov_deg;
                    // And as near as that allows; a wide view stays a little away.
                    if (fov_deg < 100) {
                        EXPECT_GE(std::max(most.x, most.y), 0.8);
                    }
                }
}

TEST(Overview, HoldsItAllAroundATurntable) {
    for (const Grid& grid : grids)
        for (const double aspect : {16.0 / 9, 0.5}) {
            const render::Camera camera = render::overview(grid, 0, 700, {aspect, 50, true});
            const glm::dvec2 middle(grid.width_m() / 2, grid.height_m() / 2);
            for (const render::Camera& turned : app::turn_around(camera, middle, 24)) {
                const Extent extent = extent_of(grid, turned, aspect, 0, 700);
                const glm::dvec2 most = glm::max(-extent.low, extent.high);
                EXPECT_LE(std::max(most.x, most.y), 0.95) << grid.nx << " x " << grid.ny << ", " << aspect;
            }
        }
}

// The same seen in pictures: the ground touches none of their four sides.
TEST(Overview, PicturesHaveSkyAllAround) {
    const gpu::Context context;
    for (const Grid& grid : {Grid{129, 129, 20, 20}, Grid{400, 30, 10, 10}, Grid{20, 300, 10, 25}}) {
        const std::vector<float> heights = generate_heights(grid, {"mountains", 2, 600});
        Terrain terrain(bedrock_terrain(grid, heights));
        render::Renderer renderer(terrain, 8);
        const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
        for (const glm::ivec2 size : {glm::ivec2(320, 180), glm::ivec2(120, 300)}) {
            const render::Camera camera =
                render::overview(grid, *low, *high, {static_cast<double>(size.x) / size.y});
            renderer.forget();
            renderer.draw(terrain, camera, {}, size.x, size.y);
            const std::vector<float> depth = renderer.read_depth(size.x, size.y);
            const render::CameraRays rays = camera_rays(camera, size.x, size.y);
            int hits = 0;
            int beside = 0;
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x) {
                    // The side that it is cut out by goes on below its lowest ground.
                    const double distance_m = depth[static_cast<std::size_t>(y) * size.x + x];
                    const glm::dvec3 ray = rays.middle + (2 * (x + 0.5) / size.x - 1) * rays.right +
                                           (1 - 2 * (y + 0.5) / size.y) * rays.up;
                    const bool hit = std::isfinite(distance_m) &&
                                     camera.eye.z + distance_m * glm::normalize(ray).z >= *low - 1;
                    const bool edge = x == 0 || y == 0 || x == size.x - 1 || y == size.y - 1;
                    hits += hit ? 1 : 0;
                    beside += hit && edge ? 1 : 0;
                }
            EXPECT_EQ(beside, 0) << grid.nx << " x " << grid.ny << " in " << size.x << " x " << size.y;
            EXPECT_GT(hits, size.x * size.y / 50);
        }
    }
}

}  // namespace
}  // namespace talus::overview_test

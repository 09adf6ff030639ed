// The orthographic view straight down is a map: each pixel shows the ground at its own place, whole or in
// tiles, and what is kept of it is what is drawn afresh.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "app/core/bilinear.h"
#include "render/overview.h"
#include "render/renderer.h"
#include "render/tiled/tiled_renderer.h"
#include "sim/gpu/context.h"
#include "sim/simulation.h"
#include "sim/simulation_parameters.h"
#include "sim/terrain/generate.h"
#include "tests/scenes/load_tiles.h"
#include "tests/scenes/memory_tiles.h"

namespace talus::top_view_test {
namespace {

constexpr glm::ivec2 size(320, 200);
const Grid grid{193, 129, 12, 9};

std::vector<float> mountains() {
    return generate_heights(grid, {"mountains", 7, 900});
}

double height_at(const std::vector<float>& heights, glm::dvec2 place_m) {
    return app::bilinear({grid.column_of(place_m.x), grid.row_of(place_m.y)}, {grid.nx, grid.ny},
                         [&](int x, int y) {
                             return static_cast<double>(heights[static_cast<std::size_t>(y) * grid.nx + x]);
                         });
}

// Where a pixel of the picture is, rows from the top.
glm::dvec2 place_of(const render::Camera& camera, glm::ivec2 pixel) {
    const double pixel_m = camera.parallel_m / size.y;
    return glm::dvec2(camera.eye) +
           pixel_m * glm::dvec2(pixel.x + 0.5 - size.x / 2.0, size.y / 2.0 - pixel.y - 0.5);
}

bool is_beside(glm::dvec2 place_m, double margin_m) {
    return place_m.x < -margin_m || place_m.y < -margin_m || place_m.x > grid.width_m() + margin_m ||
           place_m.y > grid.height_m() + margin_m;
}

// Expects each pixel's distance to be that of the ground under it.
void expect_map(const std::vector<float>& depth, const render::Camera& camera,
                const std::vector<float>& heights) {
    int shown = 0;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const glm::dvec2 place_m = place_of(camera, {x, y});
            const double depth_m = depth[static_cast<std::size_t>(y) * size.x + x];
            if (is_beside(place_m, 1e-3)) {
                ASSERT_TRUE(std::isinf(depth_m)) << x << " " << y;
            } else if (!is_beside(place_m, -1e-3)) {
                ASSERT_NEAR(camera.eye.z - depth_m, height_at(heights, place_m), 2e-3) << x << " " << y;
                ++shown;
            }
        }
    EXPECT_GT(shown, size.x * size.y / 2);
}

// All of it, and a part from near.
std::vector<render::Camera> cameras(double highest_m) {
    const render::Camera all = render::top_view(grid, highest_m, {static_cast<double>(size.x) / size.y});
    render::Camera near = all;
    near.parallel_m = 217.3;
    near.eye += glm::dvec3(301.7, -199.1, 0);
    near.target += glm::dvec3(301.7, -199.1, 0);
    return {all, near};
}

TEST(TopView, ShowsTheGroundAtEachPixelsOwnPlace) {
    const gpu::Context context;
    const std::vector<float> heights = mountains();
    const Terrain terrain(bedrock_terrain(grid, heights));
    render::Renderer renderer(terrain, 8);
    for (const render::Camera& camera : cameras(900))
        for (const std::string method : {"hybrid", "mesh", "clipmap"}) {
            render::ViewSettings settings;
            settings.method = method;
            renderer.draw(terrain, camera, settings, size.x, size.y);
            expect_map(renderer.read_depth(size.x, size.y), camera, heights);
        }
}

TEST(TopView, ShowsTheSameInTiles) {
    const gpu::Context context;
    const std::vector<float> heights = mountains();
    scenes::MemoryTiles tiles(grid, heights, 32);
    render::TiledSurface surface(tiles.tree(), tiles.bounds(), 64);
    scenes::put_coarsest(surface, tiles);
    render::TiledRenderer renderer;
    for (const render::Camera& camera : cameras(900)) {
        scenes::load_tiles(surface, tiles, camera, size, 0);
        renderer.draw(surface, camera, {}, size.x, size.y);
        expect_map(renderer.read_depth(size.x, size.y), camera, heights);
    }
    // No worse than a tolerance says, by fewer tiles.
    const render::Camera all = cameras(900).front();
    const std::size_t finest = surface.look(all, size, 0).drawn.size();
    scenes::load_tiles(surface, tiles, all, size, 4);
    EXPECT_LT(surface.look(all, size, 4).drawn.size(), finest);
    renderer.draw(surface, all, {}, size.x, size.y);
    const std::vector<float> depth = renderer.read_depth(size.x, size.y);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            if (const glm::dvec2 place_m = place_of(all, {x, y}); !is_beside(place_m, -1e-3)) {
                const double depth_m = depth[static_cast<std::size_t>(y) * size.x + x];
                ASSERT_NEAR(all.eye.z - depth_m, height_at(heights, place_m), 4 * all.parallel_m / size.y);
            }
}

// A hill has its shadow where its height and the sun say so.
TEST(TopView, ThrowsShadowsToTheirPlace) {
    const gpu::Context context;
    std::vector<float> plain(grid.count(), 0.0F);
    for (int row = 40; row < 80; ++row) plain[static_cast<std::size_t>(row) * grid.nx + 90] = 300;
    const Terrain terrain(bedrock_terrain(grid, plain));
    render::Renderer renderer(terrain, 8);
    render::ViewSettings settings;
    settings.occlusion = false;
    settings.sun = glm::normalize(glm::dvec3(-1, 0, 0.5));
    const render::Camera camera = cameras(300).front();
    renderer.draw(terrain, camera, settings, size.x, size.y);
    const std::vector<std::uint8_t> rgb = renderer.read_rgb(size.x, size.y);
    const auto bright_at = [&](glm::dvec2 place_m) {
        const double pixel_m = camera.parallel_m / size.y;
        const glm::ivec2 pixel(size.x / 2.0 + (place_m.x - camera.eye.x) / pixel_m,
                               size.y / 2.0 - (place_m.y - camera.eye.y) / pixel_m);
        return static_cast<int>(rgb[3 * (static_cast<std::size_t>(pixel.y) * size.x + pixel.x)]);
    };
    // The wall stands at 1080 m and throws 600 m.
    const double y_m = grid.height_m() - 60 * grid.dy;
    for (const double x_m : {1150.0, 1400.0, 1640.0})
        EXPECT_LT(2 * bright_at({x_m, y_m}), bright_at({x_m, 60}));
    for (const double x_m : {1000.0, 1720.0, 2000.0})
        EXPECT_NEAR(bright_at({x_m, y_m}), bright_at({x_m, 60}), 40) << x_m;
}

TEST(TopView, IsKeptWhereNothingChanged) {
    const gpu::Context context;
    Simulation simulation(bedrock_terrain(grid, mountains()), Parameters(simulation_parameters()));
    const Terrain& terrain = simulation.terrain();
    render::Renderer kept(terrain, 8);
    render::Renderer fresh(terrain, 8);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(0, 1);
    const std::vector<render::Camera> looks = cameras(2000);
    for (int frame = 0; frame < 24; ++frame) {
        const render::Camera& camera = looks[static_cast<std::size_t>(frame / 12)];
        Dab dab;
        dab.x_m = grid.width_m() * unit(random);
        dab.y_m = grid.height_m() * unit(random);
        dab.radius_m = 30 + 60 * unit(random);
        dab.amount_m = 20 * unit(random);
        if (frame % 2 == 1) dab.effect = effect_of(BrushMode::lower);
        simulation.apply(dab);
        const render::Drawn drawn = kept.draw(terrain, camera, {}, size.x, size.y);
        EXPECT_EQ(drawn, frame % 12 == 0 ? render::Drawn::everything : render::Drawn::changes);
        fresh.forget();
        fresh.draw(terrain, camera, {}, size.x, size.y);
        ASSERT_EQ(kept.read_depth(size.x, size.y), fresh.read_depth(size.x, size.y)) << frame;
        ASSERT_EQ(kept.read_rgb(size.x, size.y), fresh.read_rgb(size.x, size.y)) << frame;
    }
}

TEST(TopView, LooksFromOverAllGround) {
    render::Camera camera = render::top_view(grid, 900);
    const double before_m = camera.eye.z;
    EXPECT_GT(before_m, 900);
    render::keep_over(camera, grid, 905);
    EXPECT_EQ(camera.eye.z, before_m) << "a brush that raises the ground a little does not move the eye";
    render::keep_over(camera, grid, 5000);
    EXPECT_GT(camera.eye.z, 5000);
    EXPECT_LT(camera.target.z, camera.eye.z);
}

}  // namespace
}  // namespace talus::top_view_test

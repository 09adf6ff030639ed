// Walking over ground that is read a frame late, and pictures of parts of a view.
#include <gtest/gtest.h>

#include <cmath>

#include "app/core/still.h"
#include "app/window/camera_control.h"
#include "app/window/ground_probe.h"
#include "render/overview.h"
#include "sim/gpu/context.h"
#include "sim/terrain/generate.h"
#include "tests/scenes/wait_until.h"

namespace talus::camera_test {
namespace {

const Grid grid{300, 260, 10, 10};

double bilinear(const std::vector<float>& heights, glm::dvec2 place) {
    const double column = grid.column_of(place.x);
    const double row = grid.row_of(place.y);
    const int x = static_cast<int>(column);
    const int y = static_cast<int>(row);
    const auto at = [&](int i, int j) {
        return static_cast<double>(heights[static_cast<std::size_t>(y + j) * grid.nx + x + i]);
    };
    return std::lerp(std::lerp(at(0, 0), at(1, 0), column - x), std::lerp(at(0, 1), at(1, 1), column - x),
                     row - y);
}

// A walk of 20 s over hills at 60 frames a second.
TEST(Walking, FollowsTheGroundWithoutJitter) {
    const gpu::Context context;
    const std::vector<float> heights = generate_heights(grid, {"hills", 3, 300});
    Terrain terrain(bedrock_terrain(grid, heights));
    app::GroundProbe probe;
    render::Camera camera{{700, 700, 0}, {900, 950, 40}, 60};
    const glm::dvec3 way = camera.target - camera.eye;
    probe.follow(app::ground_samples_of(terrain, camera.eye));
    while (!probe.height_m(app::ground_samples_of(terrain, camera.eye)))
        probe.follow(app::ground_samples_of(terrain, camera.eye));
    constexpr double passed_s = 1.0 / 60;
    constexpr double eye_m = 1.8;
    constexpr double speed = 10;
    camera.eye.z = *probe.height_m(app::ground_samples_of(terrain, camera.eye)) + eye_m;
    camera.target = camera.eye + way;
    double before = camera.eye.z;
    double rise_before = 0;
    double ground_before = 0;
    double ground_rise_before = 0;
    double ground_jerk = 0;
    double largest_jerk = 0;
    double largest_off = 0;
    for (int frame = 0; frame < 1200; ++frame) {
        app::walk(camera, speed * passed_s, 0);
        probe.follow(app::ground_samples_of(terrain, camera.eye));
        const std::optional<double> ground = probe.height_m(app::ground_samples_of(terrain, camera.eye));
        ASSERT_TRUE(ground) << "frame " << frame;
        ASSERT_NEAR(*ground, bilinear(heights, camera.eye), 1e-6) << "frame " << frame;
        app::stand(camera, *ground + eye_m, *ground + 0.2 * eye_m, passed_s);
        largest_off = std::max(largest_off, std::abs(camera.eye.z - *ground - eye_m));
        EXPECT_GE(camera.eye.z, *ground + 0.2 * eye_m - 1e-9);
        const double rise = (camera.eye.z - before) / passed_s;
        const double ground_rise = (*ground - ground_before) / passed_s;
        if (frame > 1) {
            largest_jerk = std::max(largest_jerk, std::abs(rise - rise_before));
            ground_jerk = std::max(ground_jerk, std::abs(ground_rise - ground_rise_before));
        }
        rise_before = rise;
        ground_rise_before = ground_rise;
        ground_before = *ground;
        before = camera.eye.z;
    }
    // Where the ground bends from patch to patch, the eye's rise may change by a sixth of the ground's in a
    // frame.
    std::printf(
        "largest change of the rise between frames %.2f m/s, of the ground's %.2f; largest distance from eye "
        "height %.2f m\n",
        largest_jerk, ground_jerk, largest_off);
    EXPECT_GT(ground_jerk, 1);
    EXPECT_LT(largest_jerk, 0.17 * ground_jerk);
    // It comes to rest, to the bit.
    for (int frame = 0; frame < 200; ++frame) {
        const std::optional<double> ground = probe.height_m(app::ground_samples_of(terrain, camera.eye));
        app::stand(camera, *ground + eye_m, *ground + 0.5 * eye_m, passed_s);
    }
    const render::Camera at_rest = camera;
    app::stand(camera, *probe.height_m(app::ground_samples_of(terrain, camera.eye)) + eye_m, 0, passed_s);
    EXPECT_EQ(camera, at_rest);
}

TEST(Walking, KeepsOutOfTheGroundAndOnItsTargetsSide) {
    render::Camera camera{{0, 0, 10}, {100, 0, 10}, 50};
    app::keep_above(camera, 25);
    EXPECT_EQ(camera.eye.z, 25);
    EXPECT_EQ(camera.target.z, 25);
    app::keep_above(camera, 3);
    EXPECT_EQ(camera.eye.z, 25);
}

// On small terrain, and on its outermost samples.
TEST(GroundProbe, ComesToRestOnSmallTerrain) {
    const gpu::Context context;
    const Grid small{7, 5, 0.1, 0.1};
    Terrain terrain(bedrock_terrain(small, std::vector<float>(small.count(), 5.0F)));
    app::GroundProbe probe;
    for (const glm::dvec2 place :
         {glm::dvec2(0, 0), glm::dvec2(small.width_m(), small.height_m()), glm::dvec2(0.3, 0.2)}) {
        EXPECT_TRUE(wait_until([&] {
            probe.follow(app::ground_samples_of(terrain, place));
            return probe.height_m(app::ground_samples_of(terrain, place)) && !probe.pending();
        }));
        EXPECT_EQ(probe.height_m(app::ground_samples_of(terrain, place)), 5.0);
        EXPECT_FALSE(probe.pending());
    }
    probe.follow(app::ground_samples_of(terrain, {0.1, 0.1}));
    EXPECT_FALSE(probe.pending());
    // What was asked of another terrain does not come.
    Terrain other(bedrock_terrain(small, std::vector<float>(small.count(), 9.0F)));
    probe.forget();
    probe.follow(app::ground_samples_of(terrain, {0.1, 0.1}));
    probe.forget();
    EXPECT_FALSE(probe.pending());
    EXPECT_TRUE(wait_until([&] {
        probe.follow(app::ground_samples_of(other, {0.1, 0.1}));
        return probe.height_m(app::ground_samples_of(other, {0.1, 0.1})).has_value();
    }));
    EXPECT_EQ(probe.height_m(app::ground_samples_of(other, {0.1, 0.1})), 9.0);
}

TEST(GroundProbe, SeesChangesAndNothingBesideTheTerrain) {
    const gpu::Context context;
    Terrain terrain(bedrock_terrain(grid, std::vector<float>(grid.count(), 5.0F)));
    app::GroundProbe probe;
    const auto wait = [&](glm::dvec2 place, double wanted) {
        wait_until([&] {
            probe.follow(app::ground_samples_of(terrain, place));
            return probe.height_m(app::ground_samples_of(terrain, place)) == wanted;
        });
        return probe.height_m(app::ground_samples_of(terrain, place));
    };
    EXPECT_EQ(wait({800, 900}, 5.0), 5.0);
    EXPECT_FALSE(probe.height_m(app::ground_samples_of(terrain, {-1, 900})));
    EXPECT_FALSE(probe.height_m(app::ground_samples_of(terrain, {2500, 2000})));
    EXPECT_EQ(wait({2990, 2590}, 5.0), 5.0);
    const std::vector<glm::vec4> raised(grid.count(), glm::vec4(9, 0, 0, 0));
    terrain.solid.back.write(terrain.solid.back.whole(), std::as_bytes(std::span(raised)));
    terrain.solid.front.write(terrain.solid.front.whole(), std::as_bytes(std::span(raised)));
    terrain.refresh({0, 0, grid.nx, grid.ny});
    EXPECT_EQ(wait({2990, 2590}, 9.0), 9.0);
}

// Tiles of a picture larger than one are the picture.
TEST(Still, IsTheSameInTiles) {
    const gpu::Context context;
    Terrain terrain(bedrock_terrain(grid, generate_heights(grid, {"mountains", 3, 800})));
    render::Renderer renderer(terrain, 32);
    const render::Camera camera = render::overview(grid, 0, 800);
    const glm::ivec2 size(2500, 90);
    for (const char* method : {"exact", "mesh", "hybrid"}) {
        render::ViewSettings settings;
        settings.method = method;
        settings.view = "slope";
        renderer.forget();
        renderer.draw(terrain, camera, settings, size.x, size.y);
        const std::vector<std::uint8_t> whole = renderer.read_rgb(size.x, size.y);
        const std::vector<float> depth = renderer.read_depth(size.x, size.y);
        const app::Still still =
            app::draw_still(app::painter_of(renderer, terrain, settings), camera, {}, size, 1);
        ASSERT_EQ(still.rgb.size(), whole.size());
        std::size_t far_off = 0;
        std::size_t hits = 0;
        for (std::size_t i = 0; i < depth.size(); ++i) {
            hits += std::isfinite(depth[i]) ? 1 : 0;
            // Rays of a tile are rounded otherwise: a crest may be missed by a hair.
            far_off += std::isfinite(depth[i]) != std::isfinite(still.depth_m[i]) ||
                               std::abs(depth[i] - still.depth_m[i]) > 1e-4F * depth[i]
                           ? 1
                           : 0;
        }
        std::printf("%s: %zu of %zu pixels differ\n", method, far_off, hits);
        EXPECT_GT(hits, 5000U);
        EXPECT_LT(far_off, hits / 1000);
    }
}

// From the top one looks at the same ground as before, about as near, and so one does again afterwards.
TEST(TopViewByHand, LooksAtTheSameGround) {
    const glm::dvec3 direction = glm::normalize(glm::dvec3(0.4, 0.7, -0.6));
    const glm::dvec3 ground(1200, 1100, 150);
    render::Camera camera{ground - 600.0 * direction, ground};
    app::look_from_top(camera, grid, 300, 1.5, ground);
    ASSERT_TRUE(camera.is_parallel());
    EXPECT_EQ(glm::dvec2(camera.eye), glm::dvec2(ground));
    EXPECT_GT(camera.eye.z, 300);
    EXPECT_NEAR(camera.parallel_m, 2 * 600 * std::tan(glm::radians(25.0)), 1e-9);
    render::Camera walker = camera;
    app::leave_top(camera, direction, 150, false);
    EXPECT_FALSE(camera.is_parallel());
    EXPECT_LT(glm::distance(camera.eye, ground - 600.0 * direction), 1e-6);
    EXPECT_LT(glm::distance(camera.target, ground), 1e-6);
    app::leave_top(walker, direction, 300, true);
    EXPECT_EQ(walker.eye, glm::dvec3(1200, 1100, 300)) << "who walks stands where the map's middle was";
    EXPECT_LT(glm::distance(glm::normalize(walker.target - walker.eye), direction), 1e-9);
    // Who sees all of it, or looks from outside at nothing, sees all of it from the top.
    render::Camera all = render::overview(grid, 0, 300, {1.5});
    app::look_from_top(all, grid, 300, 1.5, all.target);
    EXPECT_EQ(all, render::top_view(grid, 300, {1.5}));
}

}  // namespace
}  // namespace talus::camera_test

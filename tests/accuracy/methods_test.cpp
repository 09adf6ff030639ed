// Every pixel of the methods that promise it against the double twin: coverage and distance, from every kind
// of place (law 1), and nothing leaks where mesh and rays meet.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "app/claims/picture_agreement.h"
#include "render/measure.h"
#include "render/methods/method.h"
#include "render/survey.h"
#include "sim/gpu/context.h"
#include "sim/terrain/generate.h"
#include "tests/scenes/easel.h"
#include "tests/scenes/scenes.h"

namespace talus::methods_test {
namespace {

constexpr int width = 480;
constexpr int height = 270;

using scenes::distances;

class Methods : public ::testing::TestWithParam<std::string> {};

TEST_P(Methods, ErrWithinTheirTolerance) {
    const gpu::Context context;
    const scenes::Scene scene = scenes::make(GetParam());
    const struct {
        const char* method;
        double tolerance_px;
    } cases[] = {{"exact", 0}, {"hybrid", 0}, {"hybrid", 0.5}, {"hybrid", 2}};
    for (const auto& c : cases) {
        // More mesh than any device would choose.
        const claims::SurveyError found =
            claims::survey_error(scene.grid, scene.heights, c.method, c.tolerance_px, {width, height}, 8);
        for (const std::string& view : found.beyond)
            ADD_FAILURE() << c.method << " at " << c.tolerance_px << " px, " << view;
        EXPECT_EQ(found.all.beyond, 0);
        std::printf(
            "%s, %s at %.1f px: %d pixels hit, largest error %.2g px, %d wrong coverage, %d silhouettes "
            "missed",
            GetParam().c_str(), c.method, c.tolerance_px, found.all.pixels_hit, found.all.largest_px,
            found.all.wrong_coverage, found.all.silhouettes_missed);
        std::printf("; mesh %d, rays %d, ended early %d\n", found.kinds[1], found.kinds[2], found.kinds[3]);
        EXPECT_GT(found.all.pixels_hit, width * height * 4);
        if (c.tolerance_px > 0) {
            EXPECT_GT(found.kinds[1], width * height / 4) << "too little mesh was tested";
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Terrains, Methods, ::testing::ValuesIn(scenes::names()),
                         [](const auto& scene) { return scene.param; });

// Law 2: beams save steps and change no bit.
TEST(Exact, BeamsChangeNoBit) {
    const gpu::Context context;
    const scenes::Scene scene = scenes::make("fbm");
    scenes::Easel easel(scene, width, height);
    const render::Method exact = render::make_exact(render::Detail::steps);
    gpu::Program plain({"render/fullscreen.vert", "render/exact.frag"}, {"COUNT_STEPS", "NO_BEAMS"});
    const auto draw_without = [&](const render::Frame& frame) {
        frame.pyramid.bind(plain, frame.terrain);
        set_camera(plain, frame.terrain.grid(), frame.camera, frame.width, frame.height);
        frame.hits.bind({0, 0, frame.width, frame.height});
        plain.draw_fullscreen();
    };
    const render::Method without{draw_without, nullptr};
    for (const render::NamedCamera& view : render::survey(scene.grid, scene.heights)) {
        const std::vector<glm::vec2> with_beams = easel.draw(exact, view.camera, 0);
        const std::vector<glm::vec2> without_beams = easel.draw(without, view.camera, 0);
        EXPECT_EQ(distances(with_beams), distances(without_beams)) << view.name;
        double saved = 0;
        for (std::size_t i = 0; i < with_beams.size(); ++i) saved += without_beams[i].y - with_beams[i].y;
        EXPECT_GE(saved, 0) << view.name;
    }
}

// Over a shore: near sea and land by mesh, hills by rays, the far plain by rays that end early; all within
// tolerance.
TEST(Hybrid, EachWayOwnsATenthOfMixedViews) {
    const gpu::Context context;
    const scenes::Scene scene = scenes::shore();
    scenes::Easel easel(scene, width, height);
    easel.patch_pixels = 64;
    render::Measure measure(scene.grid, scene.heights);
    const render::Method hybrid = render::make_hybrid(render::Detail::kind);
    for (const render::Camera& camera : scenes::shore_views()) {
        const std::vector<glm::vec2> hits = easel.draw(hybrid, camera, 0.5);
        std::array<int, 4> kinds{};
        for (const glm::vec2 hit : hits) ++kinds[static_cast<std::size_t>(std::clamp(hit.y, 0.0F, 3.0F))];
        std::printf("mesh %.1f %%, rays %.1f %%, ended early %.1f %%\n", 100.0 * kinds[1] / (width * height),
                    100.0 * kinds[2] / (width * height), 100.0 * kinds[3] / (width * height));
        for (const int kind : {1, 2, 3})
            EXPECT_GE(kinds[static_cast<std::size_t>(kind)], width * height / 10);
        EXPECT_EQ(measure.compare(camera, width, height, distances(hits), 0.5).beyond, 0);
    }
}

// Between the ground and the mesh over it, on it, and nearer than its near plane: there rays take over.
TEST(Hybrid, IsRightFromJustAboveTheGround) {
    const gpu::Context context;
    const Grid grid{257, 257, 30, 30};
    const scenes::Scene scene{grid, generate_heights(grid, {"mountains", 8, 1500})};
    scenes::Easel easel(scene, width, height);
    render::Measure measure(scene.grid, scene.heights);
    const render::Method hybrid = render::make_hybrid(render::Detail::kind);
    std::mt19937 random(4);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int i = 0; i < 40; ++i) {
        const int column = 20 + static_cast<int>(random() % 216);
        const int row = 20 + static_cast<int>(random() % 216);
        const auto z = [&](int x, int y) {
            return static_cast<double>(
                scene.heights[static_cast<std::size_t>(row + y) * grid.nx + column + x]);
        };
        const double ground = 0.25 * (z(0, 0) + z(1, 0) + z(0, 1) + z(1, 1));
        const double hull = 0.5 * std::max(z(0, 0) + z(1, 1), z(1, 0) + z(0, 1));
        const double shares[] = {0.1, 0.5, 0.9, 1.001};
        const double above = i % 5 == 4 ? 0.5e-3 * grid.dx : shares[i % 5] * (hull - ground);
        const glm::dvec3 eye((column + 0.5) * grid.dx, (grid.ny - 1 - row - 0.5) * grid.dy, ground + above);
        const double angle = 2 * std::numbers::pi * unit(random);
        const render::Camera camera{
            eye, eye + glm::dvec3(std::cos(angle), std::sin(angle), 0.3 - unit(random)), 60};
        const std::vector<glm::vec2> hits = easel.draw(hybrid, camera, 0.5);
        const render::PictureError error = measure.compare(camera, width, height, distances(hits), 0.5);
        EXPECT_EQ(error.beyond, 0) << "eye " << above << " m over the ground, hull " << hull - ground
                                   << " m, patch " << column << ", " << row;
    }
}

// Up, down and around, and in parts of a picture: cells are looked at only where the picture may show them.
TEST(Hybrid, IsRightInEveryDirection) {
    const gpu::Context context;
    const Grid grid{513, 513, 10, 8};
    const scenes::Scene scene{grid, generate_heights(grid, {"mountains", 8, 900})};
    scenes::Easel easel(scene, width, height);
    render::Measure measure(scene.grid, scene.heights);
    const render::Method hybrid = render::make_hybrid(render::Detail::kind);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(-1, 1);
    long by_mesh = 0;
    for (int i = 0; i < 60; ++i) {
        const glm::dvec2 at = (0.5 + 0.4 * glm::dvec2(unit(random), unit(random))) *
                              glm::dvec2(grid.width_m(), grid.height_m());
        const auto column = static_cast<std::size_t>(std::lround(grid.column_of(at.x)));
        const auto row = static_cast<std::size_t>(std::lround(grid.row_of(at.y)));
        const double ground = scene.heights[row * grid.nx + column];
        const glm::dvec3 eye(at, ground + 20 + 40 * (1 + unit(random)));
        const glm::dvec3 way =
            i == 0 ? glm::dvec3(0, 0, -1) : glm::dvec3(unit(random), unit(random), unit(random) - 0.4);
        render::Camera camera{eye, eye + way, 50 + 40 * unit(random)};
        if (i % 3 == 2) {
            camera.window_share = {0.4, 0.3};
            camera.window_middle = 0.6 * glm::dvec2(unit(random), unit(random));
        }
        const std::vector<glm::vec2> hits = easel.draw(hybrid, camera, 0.5);
        for (const glm::vec2 hit : hits) by_mesh += hit.y == 1 ? 1 : 0;
        EXPECT_EQ(measure.compare(camera, width, height, distances(hits), 0.5).beyond, 0) << "camera " << i;
    }
    EXPECT_GT(by_mesh, 60L * width * height / 10);
}

// A flight low over mountains: no pixel shows what lies behind the ground, at any border of mesh and rays.
TEST(Hybrid, HasNoCracksOverAFlight) {
    const gpu::Context context;
    const Grid grid{513, 513, 10, 10};
    const scenes::Scene scene{grid, generate_heights(grid, {"mountains", 8, 900})};
    scenes::Easel easel(scene, width, height);
    render::Measure measure(scene.grid, scene.heights);
    const render::Method exact = render::make_exact(render::Detail::none);
    const render::Method hybrid = render::make_hybrid(render::Detail::kind);
    int cracks = 0;
    long borders = 0;
    for (int frame = 0; frame < 300; ++frame) {
        const double angle = 2 * std::numbers::pi * frame / 300;
        const glm::dvec2 at = glm::dvec2(0.5 * grid.width_m()) +
                              0.38 * grid.width_m() * glm::dvec2(std::cos(angle), std::sin(2 * angle));
        const auto column = static_cast<std::size_t>(grid.column_of(at.x));
        const auto row = static_cast<std::size_t>(grid.row_of(at.y));
        const double above = 8 + 250 * (0.5 + 0.5 * std::sin(7 * angle));
        const glm::dvec3 eye(at, scene.heights[row * grid.nx + column] + above);
        const render::Camera camera{eye, eye + glm::dvec3(std::cos(3 * angle), std::sin(3 * angle), -0.25),
                                    60};
        const std::vector<glm::vec2> truth = easel.draw(exact, camera, 0);
        const std::vector<glm::vec2> drawn = easel.draw(hybrid, camera, 0.5);
        for (int i = 0; i < width * height; ++i) {
            borders += i % width > 0 && (drawn[i].y == 1) != (drawn[i - 1].y == 1) ? 1 : 0;
            if (!(drawn[i].x > 1.0001F * truth[i].x)) continue;
            // Farther than the exact ray: right only where a ray beside the pixel's centre passes too.
            cracks +=
                measure.error_px(camera, width, height, i % width, i / width, drawn[i].x, 0.5) > 0.5 ? 1 : 0;
        }
    }
    EXPECT_EQ(cracks, 0);
    EXPECT_GT(borders, 50000);
    std::printf("300 frames, %ld borders of mesh and rays, %d cracks\n", borders, cracks);
}

}  // namespace
}  // namespace talus::methods_test

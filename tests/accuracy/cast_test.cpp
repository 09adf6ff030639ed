// The exact caster against its double twin: coverage and distance, from every kind of place (law 1).
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "render/cast_twin.h"
#include "render/methods/method.h"
#include "sim/gpu/context.h"
#include "sim/terrain/generate.h"
#include "tests/scenes/scenes.h"

namespace talus {
namespace {

constexpr int width = 480;
constexpr int height = 270;

struct NamedCamera {
    std::string name;
    Camera camera;
};

std::vector<NamedCamera> cameras(const scenes::Scene& scene) {
    const Grid& grid = scene.grid;
    const double w = grid.width_m();
    const double h = grid.height_m();
    const double extent = std::max(w, h);
    const auto [low_it, high_it] = std::minmax_element(scene.heights.begin(), scene.heights.end());
    const double low = *low_it;
    const double high = *high_it;
    const auto ground = [&](double x, double y) {
        const int column = static_cast<int>(std::lround(grid.column_of(x)));
        const int row = static_cast<int>(std::lround(grid.row_of(y)));
        return static_cast<double>(scene.heights[static_cast<std::size_t>(row) * grid.nx + column]);
    };
    const auto lowest = static_cast<int>(low_it - scene.heights.begin());
    const int lowest_row = lowest / grid.nx;
    const glm::dvec3 valley(lowest % grid.nx * grid.dx, (grid.ny - 1 - lowest_row) * grid.dy, low + 2);
    const glm::dvec3 middle(0.5 * w, 0.5 * h, ground(0.5 * w, 0.5 * h));
    const auto pitched = [&](double deg) {
        const double a = deg * 3.14159265358979 / 180;
        const glm::dvec3 eye(0.31 * w, 0.17 * h, high + 0.05 * extent);
        return Camera{eye, eye + glm::dvec3(0.3 * std::cos(a), 0.954 * std::cos(a), -std::sin(a)), 55};
    };
    const glm::dvec3 over(0.37 * w, 0.41 * h, high + 0.4 * extent);
    return {
        {"level", pitched(0)},
        {"-30 degrees", pitched(30)},
        {"-60 degrees", pitched(60)},
        {"straight down", {over, over - glm::dvec3(0, 0, 1), 60}},
        {"valley looking up",
         {valley, valley + glm::dvec3(0.5 * w - valley.x, 0.5 * h - valley.y, 0.3 * extent), 70}},
        {"below ground", {middle - glm::dvec3(0, 0, 30), middle + glm::dvec3(100, 30, -30), 60}},
        {"along an axis",
         {{-0.1 * w, 0.5 * h, high * 0.7 + low * 0.3}, {w, 0.5 * h, high * 0.7 + low * 0.3}, 40}},
        {"along a diagonal", {{-0.05 * w, -0.05 * h, high}, {w, h, low}, 50}},
        {"walking", {middle + glm::dvec3(0, 0, 2), middle + glm::dvec3(1, 0.4, 2.05), 60}},
        {"through the side", {{0.4 * w, -0.3 * h, 0.5 * (low + high)}, {0.5 * w, h, low - 0.2 * extent}, 50}},
        {"far away", {{-9 * w, -7 * h, high + 2 * extent}, middle, 6}},
        {"from below the sky", {{0.6 * w, 0.6 * h, low - 0.5 * extent}, {0.1 * w, 0.1 * h, high}, 60}},
    };
}

class Cast : public ::testing::TestWithParam<std::string> {};

TEST_P(Cast, AgreesWithTheDoubleTwin) {
    const gpu::Context context;
    const scenes::Scene scene = scenes::make(GetParam());
    Terrain terrain(bedrock_terrain(scene.grid, scene.heights));
    Pyramid pyramid(terrain);
    pyramid.refresh(terrain);
    maths::CastTwin<double> twin(scene.grid, scene.heights);
    const gpu::Texture hits("hits", gpu::Format::rg32f, width, height);
    const std::array<const gpu::Texture*, 1> colours = {&hits};
    const gpu::Framebuffer framebuffer("hits", colours);
    const Method exact = make_exact(false);
    int excused = 0;
    int pixels_hit = 0;
    double worst = 0;
    for (const NamedCamera& view : cameras(scene)) {
        exact({terrain, pyramid, view.camera, width, height, framebuffer});
        const auto drawn = hits.read_all<glm::vec2>();
        twin.look(scene.grid, view.camera, width, height);
        int wrong = 0;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const double distance = drawn[static_cast<std::size_t>(y) * width + x].x;
                const auto relative_error = [&](double off_x, double off_y) {
                    const double expected =
                        twin.cast_pixel(2 * (x + 0.5 + off_x) / width - 1, 2 * (y + 0.5 + off_y) / height - 1)
                            .distance_m;
                    if (expected < 0) return std::isinf(distance) ? 0.0 : HUGE_VAL;
                    if (std::isinf(distance)) return HUGE_VAL;
                    return std::abs(distance - expected) / std::max(expected, 1e-3);
                };
                pixels_hit += std::isinf(distance) ? 0 : 1;
                const double error = relative_error(0, 0);
                if (error <= 1e-4) {
                    worst = std::max(worst, error);
                    continue;
                }
                // Is there a ray less than 1/1000 pixel away that agrees? A ray that grazes a crest changes
                // its hit by metres within less than that, so the search goes down to a millionth.
                bool agrees = false;
                for (double off = 0.00099; off > 1e-6 && !agrees; off *= 0.7)
                    for (int i = 0; i < 8 && !agrees; ++i) {
                        const double angle = i * 0.785398;
                        agrees = relative_error(off * std::cos(angle), off * std::sin(angle)) <= 1e-4;
                    }
                if (agrees) {
                    ++excused;
                } else if (++wrong <= 3) {
                    ADD_FAILURE()
                        << view.name << " pixel " << x << ", " << y << ": distance " << distance
                        << ", relative error " << error << ", twin "
                        << twin.cast_pixel(2 * (x + 0.5) / width - 1, 2 * (y + 0.5) / height - 1).distance_m;
                }
            }
        }
        EXPECT_EQ(wrong, 0) << view.name;
    }
    std::printf("%s: 12 cameras, %d pixels hit, %d excused, largest relative error %.2g\n",
                GetParam().c_str(), pixels_hit, excused, worst);
    EXPECT_GT(pixels_hit, width * height * 4);
}

INSTANTIATE_TEST_SUITE_P(Terrains, Cast, ::testing::ValuesIn(scenes::names()),
                         [](const auto& scene) { return scene.param; });

// The twin itself against brute force: every patch along the ray, the smallest root of a fine march and
// bisection.
TEST(CastTwin, FindsTheFirstCrossingThatAMarchFinds) {
    const Grid grid{17, 12, 2, 3};
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<float> heights(grid.count());
    for (float& h : heights) h = static_cast<float>(8 * unit(random));
    maths::CastTwin<double> twin(grid, heights);
    const auto surface = [&](double column, double row) {
        const int i = std::clamp(static_cast<int>(std::floor(column)), 0, grid.nx - 2);
        const int j = std::clamp(static_cast<int>(std::floor(row)), 0, grid.ny - 2);
        const auto at = [&](int x, int y) {
            return static_cast<double>(heights[static_cast<std::size_t>(y) * grid.nx + x]);
        };
        const double u = column - i;
        const double v = row - j;
        return (1 - v) * ((1 - u) * at(i, j) + u * at(i + 1, j)) +
               v * ((1 - u) * at(i, j + 1) + u * at(i + 1, j + 1));
    };
    int hits = 0;
    for (int ray = 0; ray < 4000; ++ray) {
        const glm::dvec3 eye(grid.width_m() * (2 * unit(random) - 0.5),
                             grid.height_m() * (2 * unit(random) - 0.5), 12 * unit(random));
        const glm::dvec3 aim(grid.width_m() * unit(random), grid.height_m() * unit(random), 8 * unit(random));
        twin.look(grid, {eye, aim, 40}, 1, 1);
        const glm::dvec3 direction = glm::normalize(aim - eye);
        const double found = twin.cast_pixel(0, 0).distance_m;
        const double step = 0.003;
        double marched = -1;
        double clearance = 1e9;
        for (int k = 0; k < 40000; ++k) {
            const glm::dvec3 p = eye + direction * (step * k);
            const double column = grid.column_of(p.x);
            const double row = grid.row_of(p.y);
            if (column < 0 || row < 0 || column > grid.nx - 1 || row > grid.ny - 1) continue;
            const double above = p.z - surface(column, row);
            if (above <= 0) {
                marched = step * k;
                break;
            }
            clearance = std::min(clearance, above);
        }
        if (marched < 0 && clearance < 0.02) continue;  // the march itself cannot tell
        if (marched >= 0 && found >= 0 && found < marched - 1.5 * step) {
            // A graze shorter than a march step: the found place must lie on the surface.
            const glm::dvec3 p = eye + direction * found;
            EXPECT_NEAR(p.z, surface(grid.column_of(p.x), grid.row_of(p.y)), 1e-9);
            continue;
        }
        ASSERT_NEAR(found, marched, marched < 0 ? 1e-9 : 1.5 * step) << "ray " << ray;
        hits += found >= 0 ? 1 : 0;
    }
    EXPECT_GT(hits, 1000);
}

}  // namespace
}  // namespace talus

// What lies on the ground under the mouse: the brush's ring, and a stamp where it would be pressed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/renderer.h"
#include "sim/gpu/context.h"
#include "sim/passes/brush.h"

namespace talus::ring_test {
namespace {

constexpr int side_px = 400;

// A plane of 400 m from straight above, a metre a pixel.
struct Plane {
    Plane() : terrain(bedrock_terrain(grid, std::vector<float>(grid.count(), 0.0F))), renderer(terrain, 0) {
        camera.eye = {200, 200, 1000};
        camera.target = {200, 200.001, 0};
        camera.fov_deg = glm::degrees(2 * std::atan(0.2));
        settings.method = "exact";
    }
    // Where the ring changed the picture, by metres east and north.
    std::vector<bool> changed(const render::Ring& ring) {
        renderer.draw(terrain, camera, settings, side_px, side_px);
        const std::vector<std::uint8_t> plain = renderer.read_rgb(side_px, side_px);
        renderer.draw(terrain, camera, settings, side_px, side_px, ring);
        const std::vector<std::uint8_t> ringed = renderer.read_rgb(side_px, side_px);
        std::vector<bool> differs;
        for (std::size_t i = 0; i < plain.size(); i += 3)
            differs.push_back(plain[i] != ringed[i] || plain[i + 1] != ringed[i + 1] ||
                              plain[i + 2] != ringed[i + 2]);
        return differs;
    }
    static glm::dvec2 place_of(std::size_t pixel) {
        const int column = static_cast<int>(pixel) % side_px;
        const int row = static_cast<int>(pixel) / side_px;
        return {column + 0.5, side_px - row - 0.5};
    }
    gpu::Context context;
    Grid grid{41, 41, 10, 10};
    Terrain terrain;
    render::Renderer renderer;
    render::Camera camera;
    render::ViewSettings settings;
};

TEST(Ring, LiesWhereTheBrushReaches) {
    Plane plane;
    const std::vector<bool> changed = plane.changed({{150, 230}, 60});
    for (std::size_t i = 0; i < changed.size(); ++i) {
        const double from_middle = glm::distance(Plane::place_of(i), glm::dvec2(150, 230));
        if (std::abs(from_middle - 60) < 1) {
            ASSERT_TRUE(changed[i]) << i;
        } else if (std::abs(from_middle - 60) > 8 && from_middle > 10) {
            ASSERT_FALSE(changed[i]) << i;
        }
    }
}

// Below the border there is the terrain's side, which no brush reaches: no stripe runs down it.
TEST(Ring, LiesNotOnTheTerrainsSides) {
    Plane plane;
    plane.camera.eye = {200, -300, -60};
    plane.camera.target = {200, 0, -60};
    const std::vector<bool> changed = plane.changed({{200, 5}, 60});
    EXPECT_TRUE(std::isfinite(plane.renderer.read_depth(side_px, side_px)[side_px * side_px / 2]))
        << "no side is seen";
    EXPECT_EQ(std::count(changed.begin(), changed.end(), true), 0);
}

// The rectangle of a stamp is the samples that its dab changes.
TEST(Ring, AStampIsShownWhereItWouldBePressed) {
    Plane plane;
    Dab dab;
    dab.x_m = 210;
    dab.y_m = 190;
    dab.radius_m = 200;
    dab.falloff = 0;
    dab.amount_m = 5;
    dab.blend = 1;
    dab.effect = StampDab{StampMode::add, {90, 40}, 30, false};
    gpu::Texture stamp("stamp", gpu::Format::r32f, 10, 5);
    stamp.fill(1);
    const DabNumbers numbers = dab_numbers(plane.grid, dab, {10, 5});
    render::Ring ring;
    ring.at_m = {dab.x_m, dab.y_m};
    ring.radius_m = 100;
    ring.stamp = &stamp;
    ring.stamp_columns = {numbers.stamp_columns.x, -numbers.stamp_columns.y};
    ring.stamp_rows = {numbers.stamp_rows.x, -numbers.stamp_rows.y};
    const std::vector<bool> changed = plane.changed(ring);
    Brush brush(plane.terrain);
    brush.dab(plane.terrain, dab, &stamp);
    const std::vector<float> pressed = plane.terrain.ground.read_all<float>();
    int shown = 0;
    for (std::size_t i = 0; i < pressed.size(); ++i) {
        const auto column = static_cast<int>(i % 41);
        const auto row = static_cast<int>(i / 41);
        if (column == 0 || row == 0 || column == 40 || row == 40) continue;
        const std::size_t pixel =
            static_cast<std::size_t>(row) * 10 * side_px + static_cast<std::size_t>(column) * 10;
        // Away from its edge by more than the line.
        const glm::dvec2 aside(column * 10 - dab.x_m, (40 - row) * 10 - dab.y_m);
        const double turn = glm::radians(30.0);
        const glm::dvec2 within = glm::abs(glm::dvec2(aside.x * std::cos(turn) + aside.y * std::sin(turn),
                                                      aside.y * std::cos(turn) - aside.x * std::sin(turn)));
        if (std::abs(within.x - 90) < 8 || std::abs(within.y - 40) < 8) continue;
        ASSERT_EQ(changed[pixel], pressed[i] > 0) << column << ", " << row;
        shown += changed[pixel] ? 1 : 0;
    }
    EXPECT_GT(shown, 50);
}

}  // namespace
}  // namespace talus::ring_test

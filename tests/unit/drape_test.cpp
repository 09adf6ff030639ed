// A picture draped over the terrain: where it lies, and how it is filtered.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "render/renderer.h"
#include "sim/gpu/context.h"

namespace talus::drape_test {
namespace {

// Straight down, each quarter of the terrain has its quarter of the image.
TEST(Drape, LiesOverTheTerrainNorthUp) {
    const gpu::Context context;
    const Grid square{129, 129, 10, 10};
    Terrain terrain(bedrock_terrain(square, std::vector<float>(square.count(), 0.0F)));
    render::Renderer renderer(terrain, 32);
    const std::vector<std::uint8_t> image = {255, 0, 0,   255, 0,   255, 0,   255,
                                             0,   0, 255, 255, 255, 255, 255, 255};
    renderer.drape(2, 2, std::as_bytes(std::span(image)));
    const glm::dvec3 eye(640, 640, 1500);
    renderer.draw(terrain, {eye, eye - glm::dvec3(0, 0, 1), 40}, {}, 100, 100);
    const std::vector<std::uint8_t> rgb = renderer.read_rgb(100, 100);
    const auto at = [&](int x, int y) {
        const std::size_t i = 3 * (static_cast<std::size_t>(y) * 100 + x);
        return glm::ivec3(rgb[i], rgb[i + 1], rgb[i + 2]);
    };
    const glm::ivec3 north_west = at(25, 25);
    const glm::ivec3 north_east = at(75, 25);
    const glm::ivec3 south_west = at(25, 75);
    const glm::ivec3 south_east = at(75, 75);
    EXPECT_GT(2 * north_west.r, 3 * north_west.g);
    EXPECT_GT(2 * north_east.g, 3 * north_east.r);
    EXPECT_GT(2 * south_west.b, 3 * south_west.r);
    EXPECT_GT(std::min({south_east.r, south_east.g, south_east.b}), 120);
    renderer.drape(0, 0, {});
    renderer.draw(terrain, {eye, eye - glm::dvec3(0, 0, 1), 40}, {}, 100, 100);
    EXPECT_NE(renderer.read_rgb(100, 100), rgb);
}

constexpr int side = 512;
constexpr int width = 256;
constexpr int height = 144;
// From the top: there the plain is 235 m away, and a pixel shows 0.9 m of it across the view and 17 m along.
constexpr int row = 75;

// Black and white stripes of so many texels, along x or along y.
std::vector<std::uint8_t> stripes(int texels, bool along_y) {
    std::vector<std::uint8_t> rgba(std::size_t{4} * side * side, 255);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            for (int c = 0; c < 3; ++c)
                rgba[4 * (static_cast<std::size_t>(y) * side + x) + c] =
                    (along_y ? x : y) / texels % 2 == 0 ? 255 : 0;
    return rgba;
}

// From the darkest to the brightest of so many pixels, from one on by a step.
int contrast(const std::vector<std::uint8_t>& rgb, glm::ivec2 first, glm::ivec2 step, int count) {
    int low = 255;
    int high = 0;
    for (int i = 0; i < count; ++i) {
        const glm::ivec2 at = first + i * step;
        const int byte = rgb[3 * (static_cast<std::size_t>(at.y) * width + at.x)];
        low = std::min(low, byte);
        high = std::max(high, byte);
    }
    return high - low;
}
int contrast_along_the_row(const std::vector<std::uint8_t>& rgb) {
    return contrast(rgb, {0, row}, {1, 0}, width);
}

// Over a plain, which the view along the ground draws out; a texel is a metre.
class DrapeAlongThePlain : public ::testing::Test {
  protected:
    std::vector<std::uint8_t> draw(const std::vector<std::uint8_t>& image, int taps) {
        renderer.drape(side, side, std::as_bytes(std::span(image)));
        render::ViewSettings settings;
        settings.shadows = settings.occlusion = false;
        settings.numbers = {{"render.texture_taps", taps}};
        renderer.draw(terrain, camera, settings, width, height);
        return renderer.read_rgb(width, height);
    }

    const gpu::Context context;
    const Grid grid{513, 513, 1, 1};
    Terrain terrain{bedrock_terrain(grid, std::vector<float>(grid.count(), 0.0F))};
    render::Renderer renderer{terrain, 32};
    const render::Camera camera{{256, -60, 12}, {256, 256, 0}, 30};
};

TEST_F(DrapeAlongThePlain, KeepsStripesThatRunWithTheView) {
    const std::vector<std::uint8_t> image = stripes(8, true);
    const std::vector<std::uint8_t> sharp = draw(image, 16);
    const std::vector<std::uint8_t> soft = draw(image, 1);
    std::printf("contrast of 255: %d by 16 taps, %d by one\n", contrast_along_the_row(sharp),
                contrast_along_the_row(soft));
    EXPECT_GT(contrast_along_the_row(sharp), 120);
    EXPECT_LT(contrast_along_the_row(soft), 20);
}

TEST_F(DrapeAlongThePlain, AveragesStripesAcrossTheView) {
    const std::vector<std::uint8_t> rgb = draw(stripes(1, false), 16);
    const int down_the_column = contrast(rgb, {width / 2, row}, {0, 1}, 10);
    std::printf("contrast down the column: %d of 255\n", down_the_column);
    EXPECT_LT(down_the_column, 40);
}

// Where texels are larger than pixels, more taps change no bit.
TEST(Drape, IsTheSameByAnyNumberOfTapsNearby) {
    const gpu::Context context;
    const Grid grid{65, 65, 1, 1};
    Terrain terrain(bedrock_terrain(grid, std::vector<float>(grid.count(), 0.0F)));
    render::Renderer renderer(terrain, 32);
    const std::vector<std::uint8_t> image = {255, 0, 0,   255, 0,   255, 0,   255,
                                             0,   0, 255, 255, 255, 255, 255, 255};
    renderer.drape(2, 2, std::as_bytes(std::span(image)));
    const auto draw = [&](int taps) {
        render::ViewSettings settings;
        settings.numbers = {{"render.texture_taps", taps}};
        renderer.draw(terrain, {{32, 4, 9}, {32, 40, 0}, 40}, settings, width, height);
        return renderer.read_rgb(width, height);
    };
    EXPECT_EQ(draw(1), draw(16));
}

}  // namespace
}  // namespace talus::drape_test

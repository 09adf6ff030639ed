// Samples that a picture gathers at rest: the same in whatever steps, and smooth where one sample a pixel is
// not.
#include <gtest/gtest.h>

#include <cmath>

#include "render/renderer.h"
#include "sim/gpu/context.h"
#include "sim/terrain/generate.h"

namespace talus::refinement_test {
namespace {

constexpr int width = 240;
constexpr int height = 136;
const Grid grid{300, 300, 20, 20};

std::vector<float> mountains() {
    return generate_heights(grid, {"mountains", 5, 1500});
}

render::Camera over_crests() {
    return {{1500, -300, 1500}, {3200, 5000, 900}, 45};
}

void refine(render::Renderer& renderer, Terrain& terrain, int samples) {
    while (renderer.refine(terrain, samples)) {
    }
}

TEST(Refinement, IsTheSameInWhateverSteps) {
    const gpu::Context context;
    for (const char* method : {"exact", "hybrid"}) {
        Terrain terrain(bedrock_terrain(grid, mountains()));
        render::ViewSettings settings;
        settings.method = method;
        render::Renderer once(terrain, 16);
        once.draw(terrain, over_crests(), settings, width, height);
        const std::vector<std::uint8_t> plain = once.read_rgb(width, height);
        const std::vector<float> depth = once.read_depth(width, height);
        refine(once, terrain, 7);
        // Each renderer takes the marks of its own terrain.
        Terrain same(bedrock_terrain(grid, mountains()));
        render::Renderer slowly(same, 16);
        for (int samples = 1; samples <= 7; ++samples) {
            const render::Drawn drawn = slowly.draw(same, over_crests(), settings, width, height);
            EXPECT_EQ(drawn, samples == 1 ? render::Drawn::everything : render::Drawn::nothing);
            EXPECT_EQ(slowly.refine(same, samples), samples > 1);
        }
        EXPECT_FALSE(slowly.refine(same, 7));
        EXPECT_EQ(once.read_rgb(width, height), slowly.read_rgb(width, height));
        EXPECT_NE(once.read_rgb(width, height), plain);
        // Depth and picking stay those of the pixels' middles.
        EXPECT_EQ(once.read_depth(width, height), depth);
        // Fewer samples than there were are those of a fresh picture.
        EXPECT_TRUE(once.refine(terrain, 3));
        refine(once, terrain, 3);
        slowly.forget();
        slowly.draw(same, over_crests(), settings, width, height);
        refine(slowly, same, 3);
        EXPECT_EQ(once.read_rgb(width, height), slowly.read_rgb(width, height));
        EXPECT_TRUE(once.refine(terrain, 1));
        EXPECT_FALSE(once.refine(terrain, 1));
        EXPECT_EQ(once.read_rgb(width, height), plain);
        // Another picture starts anew.
        render::Camera other = over_crests();
        other.eye.x += 10;
        once.draw(terrain, other, settings, width, height);
        once.draw(terrain, over_crests(), settings, width, height);
        EXPECT_EQ(once.read_rgb(width, height), plain);
    }
}

// The mean over a pixel of a picture eight times as fine in each direction, by light and not by its root, is
// what a pixel ought to show.
TEST(Refinement, ComesCloserToTheMeanOverAPixel) {
    const gpu::Context context;
    Terrain terrain(bedrock_terrain(grid, mountains()));
    render::ViewSettings settings;
    settings.method = "exact";
    // A view whose colours don't depend on the size of a pixel.
    settings.view = "hillshade";
    render::Renderer renderer(terrain, 16);
    constexpr int finer = 8;
    renderer.draw(terrain, over_crests(), settings, finer * width, finer * height);
    const std::vector<std::uint8_t> fine = renderer.read_rgb(finer * width, finer * height);
    std::vector<double> wanted;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            double light = 0;
            for (int j = 0; j < finer; ++j)
                for (int i = 0; i < finer; ++i) {
                    const std::size_t at =
                        static_cast<std::size_t>(y * finer + j) * finer * width + x * finer + i;
                    light += fine[3 * at] / 255.0 * (fine[3 * at] / 255.0);
                }
            wanted.push_back(255 * std::sqrt(light / (finer * finer)));
        }
    const auto error = [&](int samples) {
        renderer.forget();
        renderer.draw(terrain, over_crests(), settings, width, height);
        refine(renderer, terrain, samples);
        const std::vector<std::uint8_t> rgb = renderer.read_rgb(width, height);
        double sum = 0;
        for (std::size_t i = 0; i < wanted.size(); ++i) sum += std::pow(rgb[3 * i] - wanted[i], 2);
        return std::sqrt(sum / static_cast<double>(wanted.size()));
    };
    const double one = error(1);
    const double four = error(4);
    const double sixteen = error(16);
    std::printf("root mean square error of 255: %.2f with 1 sample, %.2f with 4, %.2f with 16\n", one, four,
                sixteen);
    // Samples at random would come to a half and a quarter.
    EXPECT_LT(four, 0.65 * one);
    EXPECT_LT(sixteen, 0.3 * one);
}

}  // namespace
}  // namespace talus::refinement_test

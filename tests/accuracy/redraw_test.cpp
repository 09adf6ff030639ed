// A picture kept and mended is the picture drawn anew, bit for bit (law 2), over dabs, ticks, camera moves
// and rests.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "app/claims/picture_agreement.h"
#include "render/overview.h"
#include "render/renderer.h"
#include "sim/gpu/context.h"
#include "sim/simulation.h"
#include "sim/simulation_parameters.h"
#include "sim/terrain/generate.h"

namespace talus {
namespace {

constexpr int width = 480;
constexpr int height = 270;
constexpr std::size_t undo_bytes = 64U << 20U;

struct Scene {
    Scene(const Grid& grid, const std::vector<float>& heights)
        : simulation(bedrock_terrain(grid, heights), Parameters(simulation_parameters()), undo_bytes),
          renderer(simulation.terrain(), 16) {}
    Simulation simulation;
    Renderer renderer;
};

class Redraw : public ::testing::TestWithParam<const char*> {};

TEST_P(Redraw, KeptPicturesEqualFreshOnes) {
    const gpu::Context context;
    const KeptFrames kept = kept_frames({700, 513, 20, 20}, GetParam(), 300, {width, height});
    std::printf("%s: 300 frames, nothing drawn in %d, colours in %d, changes in %d, everything in %d\n",
                GetParam(), kept.drawn[0], kept.drawn[1], kept.drawn[2], kept.drawn[3]);
    EXPECT_EQ(kept.differing, 0);
    EXPECT_GT(kept.drawn[static_cast<std::size_t>(Drawn::nothing)], 40);
    EXPECT_GT(kept.drawn[static_cast<std::size_t>(Drawn::changes)], 80);
}

// On a plain under a low sun a tower's shadow reaches far beyond its tile, and rays end early in cells that a
// dab elsewhere makes uneven.
TEST_P(Redraw, LongShadowsAndPlainsAreRedrawn) {
    const gpu::Context context;
    const Grid grid{700, 513, 20, 20};
    std::vector<float> plain(grid.count(), 10.0F);
    // What bounds the terrain stays, so that a dab does not change all colours.
    plain[0] = 0;
    plain[grid.count() - 1] = 2500;
    Scene kept(grid, plain);
    Scene fresh(grid, plain);
    std::mt19937 random(31);
    std::uniform_real_distribution<double> unit(0, 1);
    ViewSettings settings;
    settings.method = GetParam();
    settings.sun = glm::normalize(glm::dvec3(-0.8, 0.5, 0.18));
    const std::array<Camera, 2> cameras = {overview(grid, 0, 600),
                                           Camera{{5000, 3000, 250}, {8000, 6500, 0}, 55}};
    for (int frame = 0; frame < 120; ++frame) {
        const Camera& camera = cameras[static_cast<std::size_t>(frame / 30 % 2)];
        // The view of cells tells mesh from rays, and the level where a ray ended.
        if (frame == 60) settings.view = "cells";
        Dab dab;
        dab.mode = frame % 3 == 2 ? BrushMode::flatten : BrushMode::raise;
        dab.target_m = 10;
        dab.blend = 1;
        dab.x_m = grid.width_m() * (0.2 + 0.6 * unit(random));
        dab.y_m = grid.height_m() * (0.2 + 0.6 * unit(random));
        dab.radius_m = 40 + 200 * unit(random);
        dab.amount_m = 500 * unit(random);
        for (Scene* scene : {&kept, &fresh}) scene->simulation.apply(dab);
        const Drawn drawn = kept.renderer.draw(kept.simulation.terrain(), camera, settings, width, height);
        fresh.renderer.forget();
        fresh.renderer.draw(fresh.simulation.terrain(), camera, settings, width, height);
        EXPECT_EQ(drawn, frame % 30 == 0 ? Drawn::everything : Drawn::changes);
        ASSERT_EQ(kept.renderer.read_depth(width, height), fresh.renderer.read_depth(width, height)) << frame;
        ASSERT_EQ(kept.renderer.read_rgb(width, height), fresh.renderer.read_rgb(width, height)) << frame;
    }
}

INSTANTIATE_TEST_SUITE_P(OfMethods, Redraw, ::testing::Values("exact", "hybrid"),
                         [](const auto& method) { return std::string(method.param); });

}  // namespace
}  // namespace talus

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
#include "sim/gpu/hazards.h"
#include "sim/simulation.h"
#include "sim/simulation_parameters.h"
#include "sim/terrain/generate.h"

namespace talus::redraw_test {
namespace {

constexpr int width = 480;
constexpr int height = 270;
constexpr std::size_t undo_bytes = 64U << 20U;

struct Scene {
    Scene(const Grid& grid, const std::vector<float>& heights)
        : simulation(bedrock_terrain(grid, heights), Parameters(simulation_parameters()), undo_bytes),
          renderer(simulation.terrain(), 16) {}
    Simulation simulation;
    render::Renderer renderer;
};

class Redraw : public ::testing::TestWithParam<const char*> {};

TEST_P(Redraw, KeptPicturesEqualFreshOnes) {
    const gpu::Context context;
    const claims::KeptFrames kept = claims::kept_frames({700, 513, 20, 20}, GetParam(), 300, {width, height});
    std::printf("%s: 300 frames, nothing drawn in %d, colours in %d, changes in %d, everything in %d\n",
                GetParam(), kept.drawn[0], kept.drawn[1], kept.drawn[2], kept.drawn[3]);
    EXPECT_EQ(kept.differing, 0);
    EXPECT_GT(kept.drawn[static_cast<std::size_t>(render::Drawn::nothing)], 40);
    EXPECT_GT(kept.drawn[static_cast<std::size_t>(render::Drawn::changes)], 80);
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
    render::ViewSettings settings;
    settings.method = GetParam();
    settings.sun = glm::normalize(glm::dvec3(-0.8, 0.5, 0.18));
    const std::array<render::Camera, 2> cameras = {render::overview(grid, 0, 600),
                                                   render::Camera{{5000, 3000, 250}, {8000, 6500, 0}, 55}};
    for (int frame = 0; frame < 120; ++frame) {
        const render::Camera& camera = cameras[static_cast<std::size_t>(frame / 30 % 2)];
        // The view of cells tells mesh from rays, and the level where a ray ended.
        if (frame == 60) settings.view = "cells";
        Dab dab;
        dab.effect = effect_of(frame % 3 == 2 ? BrushMode::flatten : BrushMode::raise);
        dab.target_m = 10;
        dab.blend = 1;
        dab.x_m = grid.width_m() * (0.2 + 0.6 * unit(random));
        dab.y_m = grid.height_m() * (0.2 + 0.6 * unit(random));
        dab.radius_m = 40 + 200 * unit(random);
        dab.amount_m = 500 * unit(random);
        for (Scene* scene : {&kept, &fresh}) scene->simulation.apply(dab);
        const render::Drawn drawn =
            kept.renderer.draw(kept.simulation.terrain(), camera, settings, width, height);
        fresh.renderer.forget();
        fresh.renderer.draw(fresh.simulation.terrain(), camera, settings, width, height);
        EXPECT_EQ(drawn, frame % 30 == 0 ? render::Drawn::everything : render::Drawn::changes);
        ASSERT_EQ(kept.renderer.read_depth(width, height), fresh.renderer.read_depth(width, height)) << frame;
        ASSERT_EQ(kept.renderer.read_rgb(width, height), fresh.renderer.read_rgb(width, height)) << frame;
    }
}

// Every barrier is looked for, too.
class FollowsChanges : public ::testing::TestWithParam<std::string> {
  protected:
    void SetUp() override { gpu::hazards::keep(true); }
    void TearDown() override { gpu::hazards::keep(false); }
};

// A dab is in the next frame of every method, and in all of it: what a method keeps between frames is never
// old.
TEST_P(FollowsChanges, InTheNextFrame) {
    const gpu::Context context;
    const Grid grid{300, 260, 15, 15};
    Scene kept(grid, generate_heights(grid, {"mountains", 5, 500}));
    std::mt19937 random(12);
    std::uniform_real_distribution<double> unit(0, 1);
    render::ViewSettings settings;
    settings.method = GetParam();
    const std::array<render::Camera, 2> cameras = {render::overview(grid, 0, 500),
                                                   render::Camera{{600, 600, 900}, {2500, 2200, 200}, 55}};
    std::vector<float> before;
    int changed = 0;
    for (int frame = 0; frame < 12; ++frame) {
        const render::Camera& camera = cameras[static_cast<std::size_t>(frame / 6 % 2)];
        Dab dab;
        dab.effect = effect_of(frame % 2 == 0 ? BrushMode::raise : BrushMode::lower);
        dab.x_m = grid.width_m() * unit(random);
        dab.y_m = grid.height_m() * unit(random);
        dab.radius_m = 300;
        dab.amount_m = 200;
        kept.simulation.apply(dab);
        kept.renderer.draw(kept.simulation.terrain(), camera, settings, width, height);
        render::Renderer fresh(kept.simulation.terrain(), 16);
        fresh.draw(kept.simulation.terrain(), camera, settings, width, height);
        const std::vector<float> depth = kept.renderer.read_depth(width, height);
        ASSERT_EQ(depth, fresh.read_depth(width, height)) << frame;
        ASSERT_EQ(kept.renderer.read_rgb(width, height), fresh.read_rgb(width, height)) << frame;
        changed += depth != before ? 1 : 0;
        before = depth;
    }
    EXPECT_GE(changed, 9) << "too many dabs were out of sight";
}

std::vector<std::string> method_names() {
    std::vector<std::string> names;
    for (const render::MethodEntry& method : render::methods()) names.push_back(method.name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(OfMethods, FollowsChanges, ::testing::ValuesIn(method_names()),
                         [](const auto& method) { return method.param; });

// Any number of renderers see a live terrain, ground, water and paint: one that draws every frame, one that
// draws now and then, and one that comes late. None takes away what another has not seen yet.
TEST(Renderers, AllSeeEverythingOfOneLiveTerrain) {
    const gpu::Context context;
    const Grid grid{300, 260, 15, 15};
    Parameters parameters(simulation_parameters());
    for (const char* assignment :
         {"water.rain_mm_per_h=400", "water.sea_level_m=60", "time.tick_s=0.5", "erosion.on=true"})
        parameters.set_assignment(assignment);
    Simulation simulation(bedrock_terrain(grid, generate_heights(grid, {"mountains", 5, 500})), parameters);
    const render::Camera camera = render::overview(grid, 0, 500);
    render::Renderer each(simulation.terrain(), 16);
    render::Renderer seldom(simulation.terrain(), 16);
    std::mt19937 random(9);
    std::uniform_real_distribution<double> unit(0, 1);
    int compared = 0;
    for (int frame = 0; frame < 40; ++frame) {
        Dab dab;
        dab.material = static_cast<Material>(random() % 6);
        dab.x_m = grid.width_m() * unit(random);
        dab.y_m = grid.height_m() * unit(random);
        dab.radius_m = 100 + 300 * unit(random);
        dab.amount_m = 30 * unit(random);
        dab.blend = 0.7;
        dab.target_m = 0.8;
        simulation.apply(dab);
        if (frame % 4 == 3) simulation.apply(Ticks{1});
        render::ViewSettings settings;
        settings.view = render::views()[random() % render::views().size()].name;
        each.draw(simulation.terrain(), camera, settings, width, height);
        if (frame % 7 != 6) continue;
        seldom.draw(simulation.terrain(), camera, settings, width, height);
        render::Renderer late(simulation.terrain(), 16);
        late.draw(simulation.terrain(), camera, settings, width, height);
        ASSERT_EQ(each.read_rgb(width, height), late.read_rgb(width, height))
            << settings.view << " " << frame;
        ASSERT_EQ(seldom.read_rgb(width, height), late.read_rgb(width, height))
            << settings.view << " " << frame;
        ++compared;
    }
    EXPECT_EQ(compared, 5);
}

INSTANTIATE_TEST_SUITE_P(OfMethods, Redraw, ::testing::Values("exact", "hybrid"),
                         [](const auto& method) { return std::string(method.param); });

}  // namespace
}  // namespace talus::redraw_test

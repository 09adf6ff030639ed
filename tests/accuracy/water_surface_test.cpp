// The water's surface in the picture: where rays hit it, against the double twin; and a shoreline at rest
// stays as it is.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "render/cast_twin.h"
#include "render/renderer.h"
#include "render/survey.h"
#include "render/water_surface.h"
#include "sim/gpu/context.h"
#include "sim/simulation.h"
#include "sim/simulation_parameters.h"
#include "sim/terrain/gauge.h"
#include "sim/terrain/generate.h"

namespace talus::maths {

struct ColourTwin {
    TALUS_TWIN_NAMES(double)
#include "maths/colour_map.glsl"
};

}  // namespace talus::maths

namespace talus {
namespace {

const Grid grid{321, 257, 8, 9};

// A coast with waves on its sea and rain in its hills.
TerrainState coast() {
    return bedrock_terrain(grid, generate_heights(grid, {"coast", 3, 150}));
}
Parameters parameters() {
    Parameters all(simulation_parameters());
    for (const char* assignment :
         {"thermal.on=false", "time.tick_s=1", "water.sea_level=52", "water.boundary.west=wave",
          "water.rain=400", "water.wave_height=1.5", "water.wave_period=12"})
        all.set_assignment(assignment);
    return all;
}

TEST(WaterSurface, RaysHitItWhereTheDoubleTwinDoes) {
    const gpu::Context context;
    Simulation simulation(coast(), parameters());
    simulation.apply(Ticks{60});
    Terrain& terrain = simulation.terrain();
    WaterSurface water(terrain);
    water.refresh(terrain);
    const std::vector<float> level = water.level().read_all<float>();
    maths::CastTwin<double> twin(grid, level);
    const int width = 160;
    const int height = 90;
    std::size_t pixels = 0;
    std::size_t apart = 0;
    double largest = 0;
    for (const NamedCamera& view : survey(grid, terrain.ground.read_all<float>())) {
        const Camera& camera = view.camera;
        water.cast(terrain, camera, width, height);
        const std::vector<float> distances = water.target().read_distances(width, height);
        twin.look(grid, camera, width, height);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const double expected =
                    twin.cast_pixel((2 * x + 1.0) / width - 1, (2 * y + 1.0) / height - 1).distance_m;
                const float found = distances[static_cast<std::size_t>(y) * width + x];
                if (std::isinf(found) && expected < 0) continue;
                ++pixels;
                const double error = std::isinf(found) || expected < 0
                                         ? 1
                                         : std::abs(found - expected) / std::max(expected, 1.0);
                if (error > 1e-4)
                    ++apart;
                else
                    largest = std::max(largest, error);
            }
    }
    fmt::print("water surface: {} pixels, largest relative error {:.1e}, {} graze\n", pixels, largest, apart);
    EXPECT_GT(pixels, 50000U);
    EXPECT_EQ(apart, 0U);
}

TEST(WaterSurface, WetSamplesLieAtTheirLevelAndShoresBelowTheGround) {
    const gpu::Context context;
    Simulation simulation(coast(), parameters());
    simulation.apply(Ticks{20});
    Terrain& terrain = simulation.terrain();
    WaterSurface water(terrain);
    water.refresh(terrain);
    // Follows what changes, tile by tile, as a whole refresh would.
    for (int i = 0; i < 5; ++i) {
        simulation.apply(Ticks{3});
        Dab dab;
        dab.x_m = 900 + 150 * i;
        dab.y_m = 1000;
        dab.radius_m = 120;
        dab.amount_m = 5;
        dab.material = i % 2 == 0 ? Material::water : Material::bedrock;
        simulation.apply(dab);
        water.refresh(terrain);
    }
    const std::vector<float> followed = water.level().read_all<float>();
    terrain.tiles.mark_all();
    WaterSurface fresh(terrain);
    fresh.refresh(terrain);
    EXPECT_EQ(followed, fresh.level().read_all<float>());
    const TerrainState state = simulation.read();
    const std::vector<float> ground = state.ground();
    std::size_t wet = 0;
    for (std::size_t i = 0; i < ground.size(); ++i) {
        if (state.water[i].x >= 0.01F) {
            ++wet;
            ASSERT_EQ(followed[i], ground[i] + state.water[i].x);
        } else {
            ASSERT_LE(followed[i], ground[i]);
        }
    }
    EXPECT_GT(wet, ground.size() / 10);
}

TEST(WaterSurface, ViewsShowWhatGaugesDo) {
    const gpu::Context context;
    Simulation simulation(coast(), parameters());
    simulation.apply(Ticks{90});
    Renderer renderer(simulation.terrain(), 8);
    const std::vector<glm::vec2> inundation = simulation.read().inundation;
    const int size = 33;
    int wet = 0;
    for (const View view :
         {View::depth, View::speed, View::level, View::froude, View::largest, View::arrival})
        for (const glm::ivec2 sample : {glm::ivec2(20, 60), glm::ivec2(90, 200), glm::ivec2(130, 100),
                                        glm::ivec2(170, 140), glm::ivec2(300, 30)}) {
            const glm::dvec2 place(sample.x * grid.dx, (grid.ny - 1 - sample.y) * grid.dy);
            const GaugeReading gauge = read_gauge(simulation.terrain(), place.x, place.y);
            // The middle pixel looks straight down at the sample.
            const Camera camera{{place, 900}, {place, 0}, 20};
            ViewSettings settings;
            settings.view = view;
            settings.method = "exact";
            settings.depth_m = 40;
            settings.speed_m_per_s = 2;
            settings.level_m = 52;
            settings.level_range_m = 3;
            settings.arrival_s = 90;
            renderer.draw(simulation.terrain(), camera, settings, size, size);
            const std::vector<std::uint8_t> rgb = renderer.read_rgb(size, size);
            const std::uint8_t* middle = rgb.data() + 3 * (size / 2 * size + size / 2);
            if (gauge.depth_m < 0.01) continue;
            ++wet;
            const double speed = glm::length(gauge.velocity_m_per_s);
            maths::ColourTwin colours;
            glm::dvec3 expected = colours.colour_map(gauge.depth_m / 40);
            if (view == View::speed) expected = colours.colour_map(speed / 2);
            if (view == View::froude)
                expected = colours.colour_map(speed / std::sqrt(9.81 * gauge.depth_m) / froude_scale);
            if (view == View::level)
                expected = colours.difference_map(0.5 + 0.5 * (gauge.level_m() - 52) / 3);
            const std::size_t at = static_cast<std::size_t>(sample.y) * grid.nx + sample.x;
            if (view == View::largest) expected = colours.colour_map(inundation[at].x / 40);
            if (view == View::arrival) expected = colours.colour_map(inundation[at].y / 90);
            glm::dvec3 found(middle[0] / 255.0, middle[1] / 255.0, middle[2] / 255.0);
            // Streaks make the speed's colour lighter and darker.
            if (view == View::speed) {
                found /= found.x + found.y + found.z;
                expected /= expected.x + expected.y + expected.z;
            }
            for (int i = 0; i < 3; ++i)
                EXPECT_NEAR(found[i], expected[i], view == View::speed ? 0.01 : 0.005)
                    << "view " << static_cast<int>(view) << " at " << sample.x << " " << sample.y;
        }
    EXPECT_GE(wet, 18);
}

TEST(WaterSurface, AShorelineAtRestDoesNotFlicker) {
    const gpu::Context context;
    Parameters still(simulation_parameters());
    for (const char* assignment : {"thermal.on=false", "time.tick_s=1", "water.sea_level=52"})
        still.set_assignment(assignment);
    Simulation simulation(coast(), still);
    Renderer renderer(simulation.terrain(), 8);
    const std::vector<float> ground = simulation.read().ground();
    const auto [low, high] = std::minmax_element(ground.begin(), ground.end());
    const Camera camera = overview(grid, *low, *high);
    ViewSettings settings;
    settings.sun = glm::normalize(glm::dvec3(-1, 1, 1));
    renderer.draw(simulation.terrain(), camera, settings, 320, 180);
    const std::vector<std::uint8_t> first = renderer.read_rgb(320, 180);
    settings.view = View::hillshade;
    renderer.draw(simulation.terrain(), camera, settings, 320, 180);
    EXPECT_NE(first, renderer.read_rgb(320, 180));
    settings.view = View::shaded;
    for (int frame = 0; frame < 100; ++frame) {
        simulation.apply(Ticks{1});
        renderer.draw(simulation.terrain(), camera, settings, 320, 180);
        ASSERT_EQ(first, renderer.read_rgb(320, 180)) << "frame " << frame;
    }
}

}  // namespace
}  // namespace talus

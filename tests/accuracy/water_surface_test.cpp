// The water's surface in the picture: where rays hit it, against the double twin; and a shoreline at rest
// stays as it is.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "render/cast_twin.h"
#include "render/overview.h"
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

namespace talus::water_surface_test {
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
    render::WaterSurface water(terrain);
    water.refresh(terrain);
    const std::vector<float> level = water.level().read_all<float>();
    maths::CastTwin<double> twin(grid, level);
    const int width = 160;
    const int height = 90;
    std::size_t pixels = 0;
    std::size_t apart = 0;
    double largest = 0;
    for (const render::NamedCamera& view : render::survey(grid, terrain.ground.read_all<float>())) {
        const render::Camera& camera = view.camera;
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
    render::WaterSurface water(terrain);
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
    render::WaterSurface fresh(terrain);
    fresh.refresh(terrain);
    EXPECT_EQ(followed, fresh.level().read_all<float>());
    const TerrainState state = simulation.read();
    const std::vector<float> ground = state.ground();
    std::size_t wet = 0;
    for (std::size_t i = 0; i < ground.size(); ++i) {
        const float depth = state.water[i].x;
        if (depth >= 0.02F) {
            ++wet;
            ASSERT_EQ(followed[i], ground[i] + depth);
        } else if (depth >= 0.004F) {  // a film: between the ground and its level
            ASSERT_LE(followed[i], ground[i] + depth);
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
    render::Renderer renderer(simulation.terrain(), 8);
    const std::vector<glm::vec2> inundation = simulation.read().inundation;
    const int size = 33;
    int wet = 0;
    for (const std::string view : {"depth", "speed", "level", "froude", "largest_depth", "arrival"})
        for (const glm::ivec2 sample : {glm::ivec2(20, 60), glm::ivec2(90, 200), glm::ivec2(130, 100),
                                        glm::ivec2(170, 140), glm::ivec2(300, 30)}) {
            const glm::dvec2 place(sample.x * grid.dx, (grid.ny - 1 - sample.y) * grid.dy);
            const GaugeReading gauge = read_gauge(simulation.terrain(), place.x, place.y);
            // The middle pixel looks straight down at the sample.
            const render::Camera camera{{place, 900}, {place, 0}, 20};
            render::ViewSettings settings;
            settings.view = view;
            settings.method = "exact";
            settings.gravity_m_per_s2 = 3.7;
            settings.numbers = {{"render.depth_m", 40},
                                {"render.speed_m_per_s", 2},
                                {"render.level_m", 52},
                                {"render.level_range_m", 3},
                                {"render.arrival_s", 90}};
            renderer.draw(simulation.terrain(), camera, settings, size, size);
            const std::vector<std::uint8_t> rgb = renderer.read_rgb(size, size);
            const std::uint8_t* middle = rgb.data() + 3 * (size / 2 * size + size / 2);
            if (gauge.depth_m < 0.01) continue;
            ++wet;
            const double speed = glm::length(gauge.velocity_m_per_s);
            maths::ColourTwin colours;
            glm::dvec3 expected = colours.colour_map(gauge.depth_m / 40);
            if (view == "speed") expected = colours.colour_map(speed / 2);
            if (view == "froude") expected = colours.colour_map(speed / std::sqrt(3.7 * gauge.depth_m) / 2);
            if (view == "level") expected = colours.difference_map(0.5 + 0.5 * (gauge.level_m() - 52) / 3);
            const std::size_t at = static_cast<std::size_t>(sample.y) * grid.nx + sample.x;
            if (view == "largest_depth") expected = colours.colour_map(inundation[at].x / 40);
            if (view == "arrival") expected = colours.colour_map(inundation[at].y / 90);
            glm::dvec3 found(middle[0] / 255.0, middle[1] / 255.0, middle[2] / 255.0);
            // Streaks make the speed's colour lighter and darker.
            if (view == "speed") {
                found /= found.x + found.y + found.z;
                expected /= expected.x + expected.y + expected.z;
            }
            for (int i = 0; i < 3; ++i)
                EXPECT_NEAR(found[i], expected[i], view == "speed" ? 0.01 : 0.005)
                    << "view " << view << " at " << sample.x << " " << sample.y;
        }
    EXPECT_GE(wet, 18);
}

TEST(WaterSurface, AShorelineAtRestDoesNotFlicker) {
    const gpu::Context context;
    Parameters still(simulation_parameters());
    for (const char* assignment : {"thermal.on=false", "time.tick_s=1", "water.sea_level=52"})
        still.set_assignment(assignment);
    Simulation simulation(coast(), still);
    render::Renderer renderer(simulation.terrain(), 8);
    const std::vector<float> ground = simulation.read().ground();
    const auto [low, high] = std::minmax_element(ground.begin(), ground.end());
    const render::Camera camera = render::overview(grid, *low, *high);
    render::ViewSettings settings;
    settings.sun = glm::normalize(glm::dvec3(-1, 1, 1));
    renderer.draw(simulation.terrain(), camera, settings, 320, 180);
    const std::vector<std::uint8_t> first = renderer.read_rgb(320, 180);
    settings.view = "hillshade";
    renderer.draw(simulation.terrain(), camera, settings, 320, 180);
    EXPECT_NE(first, renderer.read_rgb(320, 180));
    settings.view = "shaded";
    for (int frame = 0; frame < 100; ++frame) {
        simulation.apply(Ticks{1});
        renderer.draw(simulation.terrain(), camera, settings, 320, 180);
        ASSERT_EQ(first, renderer.read_rgb(320, 180)) << "frame " << frame;
    }
}

// A plane that is tilted in any direction, seen from straight above, dry and with water on it.
struct TiltedPlane {
    static constexpr int samples = 97;
    static constexpr double spacing_m = 10;
    static constexpr int side_px = 480;
    static constexpr double seen_m = 600;  // of the plane's 960, across the picture

    explicit TiltedPlane(double turned_deg)
        : downhill(std::cos(glm::radians(turned_deg)), std::sin(glm::radians(turned_deg))) {}

    // Metres along the fall line from the plane's middle.
    double along_m(glm::dvec2 at_m) const { return glm::dot(at_m - middle_m(), downhill); }
    glm::dvec2 middle_m() const { return glm::dvec2((samples - 1) * spacing_m / 2); }
    glm::dvec2 place_of(int x, int y) const {
        const double pixel_m = seen_m / side_px;
        return middle_m() + pixel_m * glm::dvec2(x + 0.5 - side_px / 2.0, side_px / 2.0 - y - 0.5);
    }

    // A picture of the plane with this slope and this depth of water at a distance along the fall line.
    template <typename Depth>
    std::vector<std::uint8_t> picture(double slope, Depth&& depth_m) const {
        const Grid plane{samples, samples, spacing_m, spacing_m};
        std::vector<float> heights;
        std::vector<glm::vec4> water;
        for (int y = 0; y < samples; ++y)
            for (int x = 0; x < samples; ++x) {
                const double along = along_m({x * spacing_m, (samples - 1 - y) * spacing_m});
                heights.push_back(static_cast<float>(100 - slope * along));
                water.emplace_back(static_cast<float>(depth_m(along)), 0, 0, 0);
            }
        TerrainState state = bedrock_terrain(plane, heights);
        state.water = water;
        Terrain terrain(state);
        render::Renderer renderer(terrain, 8);
        // From far away, so that all pixels look down alike.
        render::Camera camera;
        camera.target = {middle_m(), 100};
        camera.eye = camera.target + glm::dvec3(0, 0, 20000);
        camera.fov_deg = glm::degrees(2 * std::atan(seen_m / 2 / 20000));
        render::ViewSettings settings;
        settings.sun = glm::normalize(glm::dvec3(-1, 0.4, 0.9));
        settings.shadows = settings.occlusion = false;
        renderer.draw(terrain, camera, settings, side_px, side_px);
        return renderer.read_rgb(side_px, side_px);
    }

    glm::dvec2 downhill;
};

// The waterline of a lake on a tilted plane is where its depth is zero, whichever way the grid runs.
TEST(WaterSurface, TheWaterlineFollowsNoGrid) {
    const gpu::Context context;
    constexpr double slope = 0.15;
    for (const double turned_deg : {0.0, 7.0, 22.5, 31.0, 45.0}) {
        const TiltedPlane plane(turned_deg);
        const auto dry = plane.picture(slope, [](double) { return 0.0; });
        const auto wet =
            plane.picture(slope, [&](double along) { return std::max(0.0, slope * (along - 3.7)); });
        // Where the picture begins to differ, along the fall line; on both sides of it.
        double farthest_out_m = 0;
        double farthest_in_m = 0;
        for (int y = 0; y < TiltedPlane::side_px; ++y)
            for (int x = 0; x < TiltedPlane::side_px; ++x) {
                const std::size_t i = 3 * (static_cast<std::size_t>(y) * TiltedPlane::side_px + x);
                int differs = 0;
                for (std::size_t k = 0; k < 3; ++k)
                    differs = std::max(differs, std::abs(static_cast<int>(wet[i + k]) - dry[i + k]));
                const double from_line_m = plane.along_m(plane.place_of(x, y)) - 3.7;
                if (differs > 0) farthest_out_m = std::max(farthest_out_m, -from_line_m);
                if (differs <= 5) farthest_in_m = std::max(farthest_in_m, from_line_m);
            }
        const double pixel_m = TiltedPlane::seen_m / TiltedPlane::side_px;
        fmt::print(
            "turned by {}°: water is seen from {:.2f} px before to {:.2f} px behind the waterline on\n",
            turned_deg, farthest_out_m / pixel_m, farthest_in_m / pixel_m);
        EXPECT_LE(farthest_out_m, 1.0 * pixel_m) << turned_deg;
        EXPECT_LE(farthest_in_m, 1.5 * pixel_m) << turned_deg;
    }
}

// Water that runs down between straight banks: its level falls along them as the ground does. Where level and
// ground meet is known, and the picture's waterline shall lie there, whichever way the grid runs. The level
// of a dry sample is a guess from the wet ones beside it, so a few hundredths of a cell are what is to be
// had.
TEST(WaterSurface, TheWaterlineOfAStreamFollowsNoGrid) {
    const gpu::Context context;
    constexpr int samples = 97;
    constexpr double spacing_m = 10;
    constexpr double fall = 0.1;  // steeper water is drawn as a sheet
    constexpr double bank = 0.25;
    constexpr double deepest_m = 6;
    const Grid plane{samples, samples, spacing_m, spacing_m};
    for (const double turned_deg : {0.0, 10.0, 22.5, 31.0, 45.0}) {
        const glm::dvec2 along(std::cos(glm::radians(turned_deg)), std::sin(glm::radians(turned_deg)));
        const glm::dvec2 across(-along.y, along.x);
        std::vector<float> heights;
        std::vector<glm::vec4> water;
        for (int row = 0; row < samples; ++row)
            for (int column = 0; column < samples; ++column) {
                const glm::dvec2 at = spacing_m * (glm::dvec2(column, row) - (samples - 1) / 2.0);
                const double above_m = bank * std::abs(glm::dot(at, across));
                heights.push_back(static_cast<float>(100 - fall * glm::dot(at, along) + above_m));
                water.emplace_back(static_cast<float>(std::max(0.0, deepest_m - above_m)), 0, 0, 0);
            }
        TerrainState state = bedrock_terrain(plane, heights);
        state.water = water;
        const Terrain terrain(state);
        render::WaterSurface surface(terrain);
        surface.refresh(terrain);
        const std::vector<float> level = surface.level().read_all<float>();
        const auto depth_at = [&](glm::dvec2 at) {
            const glm::dvec2 place = at / spacing_m + (samples - 1) / 2.0;
            const glm::ivec2 cell(place);
            const glm::dvec2 w = place - glm::dvec2(cell);
            double sum = 0;
            for (int i = 0; i < 4; ++i) {
                const std::size_t sample =
                    static_cast<std::size_t>(cell.y + i / 2) * samples + cell.x + i % 2;
                sum += (i % 2 == 0 ? 1 - w.x : w.x) * (i < 2 ? 1 - w.y : w.y) *
                       (static_cast<double>(level[sample]) - heights[sample]);
            }
            return sum;
        };
        double squares = 0;
        double largest = 0;
        int places = 0;
        for (int i = -150; i <= 150; ++i)
            for (const double side : {-1.0, 1.0}) {
                double out_m = 0;
                while (out_m < 100 && depth_at(2.0 * i * along + side * out_m * across) > 0) out_m += 0.05;
                const double error = (out_m - deepest_m / bank) / spacing_m;
                squares += error * error;
                largest = std::max(largest, std::abs(error));
                ++places;
            }
        const double error = std::sqrt(squares / places);
        fmt::print("a stream turned by {}°: its waterline is {:.2f} cells off, {:.2f} at most\n", turned_deg,
                   error, largest);
        EXPECT_LE(error, 0.05) << turned_deg;
        EXPECT_LE(largest, 0.15) << turned_deg;
    }
}

// A film that thickens along the fall line is seen by its depth alone: nothing in the picture follows the
// grid.
TEST(WaterSurface, AFilmFadesWithItsDepth) {
    const gpu::Context context;
    for (const double turned_deg : {0.0, 13.0, 45.0}) {
        const TiltedPlane plane(turned_deg);
        const auto depth_m = [](double along) { return std::max(0.0, 0.03 * (along + 250) / 500); };
        const auto dry = plane.picture(0.1, [](double) { return 0.0; });
        const auto wet = plane.picture(0.1, depth_m);
        // What the water changes at each depth, in steps of 0.25 mm: the brightest and the darkest pixel.
        std::vector<glm::ivec2> changes(200, glm::ivec2(1000, -1000));
        for (int y = 0; y < TiltedPlane::side_px; ++y)
            for (int x = 0; x < TiltedPlane::side_px; ++x) {
                const std::size_t i = 3 * (static_cast<std::size_t>(y) * TiltedPlane::side_px + x) + 1;
                const double depth = depth_m(plane.along_m(plane.place_of(x, y)));
                glm::ivec2& change = changes[static_cast<std::size_t>(depth / 0.00025)];
                change.x = std::min(change.x, static_cast<int>(wet[i]) - dry[i]);
                change.y = std::max(change.y, static_cast<int>(wet[i]) - dry[i]);
            }
        int widest = 0;
        int steepest = 0;
        for (std::size_t k = 1; k < changes.size(); ++k) {
            if (changes[k].x > changes[k].y || changes[k - 1].x > changes[k - 1].y) continue;
            widest = std::max(widest, changes[k].y - changes[k].x);
            steepest = std::max(
                steepest, std::abs(changes[k].x + changes[k].y - changes[k - 1].x - changes[k - 1].y) / 2);
        }
        const glm::ivec2 none = changes[8];    // at 2 mm
        const glm::ivec2 most = changes[118];  // at 29.5 mm
        fmt::print(
            "turned by {}°: at one depth {} levels apart at most, from depth to depth {}; in all {} to {}\n",
            turned_deg, widest, steepest, none.x, most.x);
        EXPECT_LE(widest, 6) << turned_deg;
        EXPECT_LE(steepest, 2) << turned_deg;
        EXPECT_EQ(none, glm::ivec2(0)) << "2 mm are no surface";
        EXPECT_GT(std::abs(most.x), 2) << "3 cm are seen";
    }
}

}  // namespace
}  // namespace talus::water_surface_test

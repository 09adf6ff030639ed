// Which height of a stamp stands on the ground.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "app/core/app_parameters.h"
#include "app/core/sources.h"
#include "app/tools/brush_stroke.h"
#include "sim/gpu/context.h"
#include "sim/io/heightmap.h"
#include "sim/simulation.h"
#include "sim/simulation_parameters.h"

namespace talus::stamp_test {
namespace {

constexpr int side = 33;
constexpr int half = side / 2;
constexpr double bowl_m = 50;
constexpr double rim_m = 12;  // what the file's border is above its 0

// A file of signed floats: a bowl in level ground.
std::string bowl_file() {
    io::Heightmap heightmap;
    heightmap.grid = {side, side, 10, 10};
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const double from_middle = std::hypot(x - half, y - half) / half;
            const double depth = bowl_m * std::max(0.0, 1 - from_middle * from_middle);
            heightmap.heights.push_back(static_cast<float>(rim_m - depth));
        }
    std::string path = (std::filesystem::temp_directory_path() / "talus_bowl.tif").string();
    io::write_heightmap(path, heightmap, std::nullopt);
    return path;
}

// What the stamp does to level ground of 100 m: in its middle, and at its border.
struct Pressed {
    double middle_m;
    double border_m;
};
Pressed pressed(const Stamp& stamp, const ChooseStamp& choose, const std::string& zero,
                const std::string& mode, bool inverted = false) {
    const Grid grid{65, 65, 10, 10};
    Simulation simulation(bedrock_terrain(grid, std::vector<float>(grid.count(), 100)),
                          Parameters(simulation_parameters()));
    simulation.apply(choose);
    Parameters view(app::app_parameters());
    view.set("brush.tool", std::string("stamp"));
    view.set("brush.radius_m", 160.0);
    view.set("brush.falloff", 0.0);
    view.set("stamp.mode", mode);
    if (!zero.empty()) view.set("stamp.zero", zero);
    app::Modifiers modifiers;
    modifiers.inverted = inverted;
    Dab dab = app::tool_dab(view, modifiers, 100, 0, &stamp);
    dab.x_m = dab.y_m = 320;
    simulation.apply(dab);
    const std::vector<float> ground = simulation.read().ground();
    const auto at = [&](int x, int y) {
        return static_cast<double>(ground[static_cast<std::size_t>(y) * 65 + x]) - 100;
    };
    return {at(32, 32), at(32 - half, 32)};
}

TEST(Stamp, ABowlDigsUnlessItsLowestSampleStandsOnTheGround) {
    const gpu::Context context;
    const ChooseStamp choose = app::read_stamp(bowl_file(), {});
    const Stamp& stamp = *choose.stamp;
    EXPECT_NEAR(stamp.relief_m, bowl_m, 1e-4);
    constexpr double near_m = 1e-3;
    // Unless set, the border stays where the ground is.
    for (const std::string zero : {"", "border"}) {
        const Pressed bowl = pressed(stamp, choose, zero, "add");
        EXPECT_NEAR(bowl.middle_m, -bowl_m, near_m);
        EXPECT_NEAR(bowl.border_m, 0, near_m);
    }
    EXPECT_NEAR(pressed(stamp, choose, "border", "add", true).middle_m, bowl_m, near_m);
    EXPECT_NEAR(pressed(stamp, choose, "lowest", "add").middle_m, 0, near_m);
    EXPECT_NEAR(pressed(stamp, choose, "lowest", "add").border_m, bowl_m, near_m);
    EXPECT_NEAR(pressed(stamp, choose, "file", "add").middle_m, rim_m - bowl_m, near_m);
    EXPECT_NEAR(pressed(stamp, choose, "file", "add").border_m, rim_m, near_m);
    EXPECT_NEAR(pressed(stamp, choose, "border", "replace").middle_m, -bowl_m, near_m);
    EXPECT_NEAR(pressed(stamp, choose, "border", "lower").middle_m, -bowl_m, near_m);
    EXPECT_NEAR(pressed(stamp, choose, "border", "higher").middle_m, 0, near_m);
}

TEST(Stamp, LevelGroundIsAPlateau) {
    const Grid grid{5, 5, 1, 1};
    const Stamp level = stamp_of(grid, std::vector<float>(25, 7));
    EXPECT_EQ(level.heights, std::vector<float>(25, 1));
    for (const StampZero zero : {StampZero::border, StampZero::lowest, StampZero::file})
        EXPECT_EQ(zero_of(level, zero), 0);
}

}  // namespace
}  // namespace talus::stamp_test

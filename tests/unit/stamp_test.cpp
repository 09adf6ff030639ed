// Which height of a stamp stands on the ground.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/core/app_parameters.h"
#include "app/core/sources.h"
#include "app/tools/brush_stroke.h"
#include "sim/error.h"
#include "sim/gpu/context.h"
#include "sim/io/heightmap.h"
#include "sim/journal.h"
#include "sim/simulation.h"
#include "sim/simulation_parameters.h"
#include "sim/terrain/ground_shape.h"
#include "sim/terrain/stamp_shapes.h"

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

// Of a stamp's samples, along the line from its middle eastwards: metres.
std::vector<double> profile(const Stamp& stamp) {
    std::vector<double> heights_m;
    const int middle = stamp.grid.ny / 2;
    for (int x = stamp.grid.nx / 2; x < stamp.grid.nx; ++x)
        heights_m.push_back(
            stamp.relief_m *
            (stamp.heights[static_cast<std::size_t>(middle) * stamp.grid.nx + x] - stamp.border));
    return heights_m;
}

TEST(StampShelf, StandsOnTheGroundAtItsBorder) {
    for (const StampShape& shape : stamp_shapes()) {
        const Stamp stamp = shaped_stamp(shape.name);
        EXPECT_GT(stamp.relief_m, 5) << shape.name;
        for (int i = 0; i < 257; ++i)
            for (const std::size_t at :
                 {static_cast<std::size_t>(i), 256UL * 257 + i, 257UL * i, 257UL * i + 256})
                EXPECT_NEAR(stamp.relief_m * (stamp.heights[at] - stamp.border), 0, 1e-4) << shape.name;
        // Nothing is steeper than a cliff of 75 degrees.
        const std::vector<float> slopes = slopes_deg(stamp.grid, [&] {
            std::vector<float> heights_m = stamp.heights;
            for (float& height : heights_m) height *= static_cast<float>(stamp.relief_m);
            return heights_m;
        }());
        EXPECT_LT(*std::max_element(slopes.begin(), slopes.end()), 75) << shape.name;
    }
    EXPECT_THROW(shaped_stamp("cube"), Error);
}

// Pike 1977: 0.196 of the diameter deep below the rim, which is 0.036 of it above the ground.
TEST(StampShelf, ACraterHasTheMeasuresOfCraters) {
    const std::vector<double> heights_m = profile(shaped_stamp("crater"));
    const auto crest = std::max_element(heights_m.begin(), heights_m.end());
    const double diameter_m = 2 * static_cast<double>(crest - heights_m.begin()) * 1000 / 256;
    EXPECT_NEAR(diameter_m, 450, 45);
    EXPECT_NEAR((*crest - heights_m.front()) / diameter_m, 0.196, 0.02);
    EXPECT_NEAR(*crest / diameter_m, 0.036, 0.005);
}

// The lee of dunes stands at the angle of repose, their backs are gentle: steep ground faces one way.
TEST(StampShelf, DunesFaceTheWind) {
    const Stamp stamp = shaped_stamp("dunes");
    const auto height_m = [&](int x, int y) {
        return stamp.relief_m * stamp.heights[static_cast<std::size_t>(y) * 257 + x];
    };
    int falls = 0;
    int rises = 0;
    double steepest = 0;
    for (int y = 90; y < 168; ++y)
        for (int x = 90; x < 168; ++x) {
            const double slope = (height_m(x + 1, y) - height_m(x - 1, y)) / (2 * stamp.grid.dx);
            falls += slope < -0.35 ? 1 : 0;
            rises += slope > 0.35 ? 1 : 0;
            steepest = std::max(steepest, -slope);
        }
    EXPECT_GT(falls, 500);
    EXPECT_LT(rises, falls / 50);
    EXPECT_NEAR(std::atan(steepest) * 180 / 3.14159265, 33, 6);
}

TEST(StampShelf, IsAsHighAsItIsWideUnlessSomebodySays) {
    const gpu::Context context;
    const ChooseStamp choose = app::shelf_stamp("crater");
    const Stamp& stamp = *choose.stamp;
    // 320 m wide of 1000 m.
    EXPECT_NEAR(pressed(stamp, choose, "", "add").middle_m, 0.32 * profile(stamp).front(), 0.01);
    EXPECT_NEAR(natural_relief_m(stamp, 500), stamp.relief_m / 2, 1e-9);
    const Stamp from_file = *app::read_stamp(bowl_file(), {}).stamp;
    EXPECT_EQ(natural_relief_m(from_file, 500), from_file.relief_m);
}

TEST(StampShelf, IsMadeAgainFromAJournal) {
    Journal journal;
    journal.record(app::shelf_stamp("mesa"));
    JournalFile read = read_journal(write_journal({}, journal), "shelf");
    ASSERT_EQ(read.operations.size(), 1U);
    EXPECT_EQ(name_of(read.operations[0]), "stamp: Mesa");
    const gpu::Context context;
    const Grid grid{33, 33, 10, 10};
    const Simulation simulation(bedrock_terrain(grid, std::vector<float>(grid.count(), 0)),
                                Parameters(simulation_parameters()));
    app::read_sources(read.operations[0], simulation, false);
    EXPECT_EQ(std::get<ChooseStamp>(read.operations[0]).stamp->heights, shaped_stamp("mesa").heights);
    auto& choose = std::get<ChooseStamp>(read.operations[0]);
    choose.source.hash ^= 1;
    EXPECT_THROW(app::read_sources(read.operations[0], simulation, false), Error);
}

}  // namespace
}  // namespace talus::stamp_test

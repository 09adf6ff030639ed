// Sections: the staircase along a line, and the water that passes it, to what is on both sides of it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "app/core/sections.h"
#include "sim/error.h"
#include "sim/gpu/context.h"
#include "sim/simulation.h"
#include "sim/simulation_parameters.h"
#include "sim/terrain/generate.h"
#include "sim/terrain/section.h"
#include "tests/scenes/parameters_with.h"

namespace talus::section_test {
namespace {

// What an even flow (m²/s east and north) brings over it to the right, m³/s.
double even_flow_over(const Grid& grid, const std::vector<SectionFace>& faces, glm::dvec2 flow) {
    double sum = 0;
    for (const SectionFace& face : faces)
        sum += face.sign * (face.is_row ? flow.y * grid.dx : flow.x * grid.dy);
    return sum;
}

TEST(Sections, AStaircaseStaysAtItsLine) {
    const Grid grid{60, 50, 10, 8};
    std::mt19937 random(4);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int trial = 0; trial < 300; ++trial) {
        Section section{{grid.width_m() * unit(random), grid.height_m() * unit(random)},
                        {grid.width_m() * unit(random), grid.height_m() * unit(random)}};
        if (trial % 5 == 0) section.to_m.x = section.from_m.x;
        if (trial % 5 == 1) section.to_m.y = section.from_m.y;
        if (glm::distance(section.from_m, section.to_m) < 30) continue;
        const std::vector<SectionFace> faces = faces_of(grid, section);
        const glm::dvec2 along = section.to_m - section.from_m;
        // As many faces as the corners lie apart, each nearer to the line than a cell's diagonal.
        EXPECT_NEAR(static_cast<double>(faces.size()),
                    std::abs(along.x) / grid.dx + std::abs(along.y) / grid.dy, 2);
        for (const SectionFace& face : faces) {
            const double column = face.is_row ? face.at.x : face.at.x - 0.5;
            const double row = face.is_row ? face.at.y + 0.5 : face.at.y;
            const glm::dvec2 middle(column * grid.dx, (grid.ny - 1 - row) * grid.dy);
            const glm::dvec2 off = middle - section.from_m;
            EXPECT_LE(std::abs(off.x * along.y - off.y * along.x) / glm::length(along), std::hypot(10, 8));
            EXPECT_TRUE(face.at.x >= 0 && face.at.x <= grid.nx && face.at.y >= -1 && face.at.y < grid.ny);
        }
        // An even flow passes as it passes the line, but for what the ends move to corners.
        for (const glm::dvec2 flow : {glm::dvec2(1, 0), glm::dvec2(0, 1), glm::dvec2(-0.3, 0.8)})
            EXPECT_NEAR(even_flow_over(grid, faces, flow), flow.x * along.y - flow.y * along.x,
                        (std::abs(flow.x) + std::abs(flow.y)) * 10.01);
        // Looked at from the other end it is positive on the other side.
        const std::vector<SectionFace> back = faces_of(grid, {section.to_m, section.from_m});
        EXPECT_NEAR(even_flow_over(grid, back, {0.4, 0.7}), -even_flow_over(grid, faces, {0.4, 0.7}), 1e-9);
    }
}

// From edge to edge nothing is left out, and a line along an edge is that edge, whatever rounding makes of
// its metres.
TEST(Sections, ReachTheMapsEdges) {
    for (const double spacing : {10.0, 0.1, 1.0 / 3, 30.87}) {
        const Grid grid{60, 50, spacing, 0.7 * spacing};
        const double w = grid.width_m();
        const double h = grid.height_m();
        EXPECT_EQ(faces_of(grid, {{0.4 * w, 0}, {0.4 * w, h}}).size(), 50U);
        EXPECT_EQ(faces_of(grid, {{w, 0.3 * h}, {0, 0.3 * h}}).size(), 60U);
        EXPECT_EQ(faces_of(grid, {{0, 0}, {w, h}}).size(), 110U);
        const std::vector<SectionFace> west = faces_of(grid, {{0, h}, {0, 0}});
        ASSERT_EQ(west.size(), 50U);
        for (const SectionFace& face : west) EXPECT_TRUE(!face.is_row && face.at.x == 0 && face.sign == -1);
        for (const SectionFace& face : faces_of(grid, {{0, h}, {w, h}}))
            EXPECT_TRUE(face.is_row && face.at.y == -1);
        for (const SectionFace& face : faces_of(grid, {{w, 0}, {w, h}}))
            EXPECT_TRUE(!face.is_row && face.at.x == 60);
        for (const SectionFace& face : faces_of(grid, {{w, 0}, {0, 0}}))
            EXPECT_TRUE(face.is_row && face.at.y == 49);
    }
}

TEST(Sections, RefuseWhatIsNoLineOnTheMap) {
    const Grid grid{60, 50, 10, 8};
    EXPECT_THROW(check_section(grid, {{-1, 0}, {100, 100}}), Error);
    EXPECT_THROW(check_section(grid, {{0, 0}, {100, 1e9}}), Error);
    EXPECT_THROW(check_section(grid, {{100, 100}, {101, 101}}), Error);
    EXPECT_THROW(check_section(grid, {{100, std::nan("")}, {101, 101}}), Error);
    EXPECT_NO_THROW(check_section(grid, {{0, 0}, {590, 392}}));
}

class EitherOrderOfSections : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Sections, EitherOrderOfSections, testing::Values(1, 2));

// Water sloshes through sections that cut the map in two: what passed them is what there is more on their
// right.
TEST_P(EitherOrderOfSections, CountWhatComesToTheOtherSide) {
    const gpu::Context context;
    const Grid grid{150, 130, 6, 5};
    Parameters all =
        parameters_with({"time.tick_s=2", "water.boundary.north=wall", "water.boundary.south=wall",
                         "water.boundary.west=wall", "water.boundary.east=wall"});
    all.set("water.order", GetParam());
    TerrainState start = bedrock_terrain(grid, generate_heights(grid, {"hills", 7, 12}));
    start.water.assign(grid.count(), glm::vec4(0));
    for (std::size_t i = 0; i < grid.count(); ++i)
        if (i % 150 < 70) start.water[i].x = std::max(0.0F, 11 - start.bedrock[i].x);
    Simulation simulation(start, all);
    const double width = grid.width_m();
    const double height = grid.height_m();
    // From north to south the right side is west; from the west edge to the east edge it is south.
    const std::vector<Section> sections = {{{0.5 * width, height}, {0.5 * width, 0}},
                                           {{0.3 * width, height}, {0.8 * width, 0}},
                                           {{0, 0.2 * height}, {width, 0.9 * height}}};
    simulation.follow_sections(sections);
    const auto on_the_right = [&](const Section& section, const TerrainState& state) {
        // Whether a sample lies on the right of the staircase: count from the side where the map's edge is.
        std::vector<int> reach(static_cast<std::size_t>(grid.ny), 0);
        const std::vector<SectionFace> faces = faces_of(grid, section);
        double sum = 0;
        if (section.from_m.x > 0) {  // from north to south: samples west of each row's face
            for (const SectionFace& face : faces)
                if (!face.is_row) reach[static_cast<std::size_t>(face.at.y)] = face.at.x;
            for (int row = 0; row < grid.ny; ++row)
                for (int column = 0; column < reach[static_cast<std::size_t>(row)]; ++column) {
                    const glm::vec4& water = state.water[static_cast<std::size_t>(row) * grid.nx + column];
                    sum += static_cast<double>(water.x) + water.y;
                }
        } else {  // from west to east: samples south of each column's face
            for (const SectionFace& face : faces)
                if (face.is_row)
                    for (int row = face.at.y + 1; row < grid.ny; ++row) {
                        const glm::vec4& water =
                            state.water[static_cast<std::size_t>(row) * grid.nx + face.at.x];
                        sum += static_cast<double>(water.x) + water.y;
                    }
        }
        return sum * grid.dx * grid.dy;
    };
    double moved = 0;
    for (int i = 0; i < 4; ++i) {
        simulation.apply(Ticks{10});
        const TerrainState now = simulation.read();
        const std::vector<double> volumes = simulation.section_volumes_m3();
        ASSERT_EQ(volumes.size(), sections.size());
        for (std::size_t s = 0; s < sections.size(); ++s) {
            const double gained = on_the_right(sections[s], now) - on_the_right(sections[s], start);
            EXPECT_NEAR(volumes[s], gained, 1e-6 * on_the_right(sections[s], start)) << "section " << s;
            moved = std::max(moved, std::abs(gained));
        }
    }
    EXPECT_GT(moved, 1e5);
}

TEST(Sections, ChangeNoBitAndGoBackWithUndo) {
    const gpu::Context context;
    const Grid grid{100, 90, 10, 10};
    const TerrainState start = bedrock_terrain(grid, generate_heights(grid, {"coast", 5, 30}));
    const Parameters all = parameters_with(
        {"time.tick_s=2", "water.boundary.west=inflow", "water.inflow=300", "water.rain=300"});
    Simulation plain(start, all);
    plain.apply(Ticks{30});
    Simulation counted(start, all, 64U << 20U);
    counted.follow_sections({{{0, 300}, {990, 500}}});
    counted.apply(Ticks{15});
    counted.end_entry();
    const std::vector<double> midway = counted.section_volumes_m3();
    // Another begins; the first goes on.
    counted.follow_sections({{{500, 0}, {500, 890}}, {{0, 300}, {990, 500}}});
    EXPECT_EQ(counted.section_volumes_m3(), (std::vector<double>{0, midway[0]}));
    counted.apply(Ticks{15});
    counted.end_entry();
    EXPECT_EQ(counted.read().water, plain.read().water);
    const std::vector<double> last = counted.section_volumes_m3();
    EXPECT_GT(std::abs(last[0]), 1);
    counted.undo();
    EXPECT_EQ(counted.section_volumes_m3(), (std::vector<double>{0, midway[0]}));
    counted.redo();
    EXPECT_EQ(counted.section_volumes_m3(), last);
    // To before the other was there, and the first goes on from what it had then.
    counted.undo();
    counted.undo();
    EXPECT_EQ(counted.section_volumes_m3(), (std::vector<double>{0, 0}));
    counted.redo();
    EXPECT_EQ(counted.section_volumes_m3(), (std::vector<double>{0, midway[0]}));
    counted.follow_sections({{{0, 300}, {990, 500}}});
    EXPECT_EQ(counted.section_volumes_m3(), midway);
}

// A window takes rows without waiting; they are those that a run takes.
TEST(Sections, FollowWithoutWaiting) {
    const gpu::Context context;
    const Grid grid{100, 90, 10, 10};
    Simulation simulation(
        bedrock_terrain(grid, generate_heights(grid, {"coast", 5, 30})),
        parameters_with({"time.tick_s=2", "water.boundary.west=inflow", "water.inflow=300"}), 64U << 20U);
    app::Sections followed;
    app::Sections recorded;
    // Downstream, east, is on the right of one who looks north.
    const Section across{{10, 0}, {10, 890}};
    for (app::Sections* one : {&followed, &recorded}) one->place(simulation, across);
    const auto take_rows = [&] {
        recorded.record(simulation);
        for (int i = 0; i < 100000 && followed.times_s() != recorded.times_s(); ++i)
            followed.follow(simulation);
    };
    take_rows();
    for (int i = 0; i < 6; ++i) {
        simulation.apply(Ticks{3});
        take_rows();
    }
    simulation.end_entry();
    EXPECT_EQ(followed.to_csv(), recorded.to_csv());
    EXPECT_GT(followed.all()[0].volumes_m3.back(), 100);
    EXPECT_GT(followed.discharge_m3_per_s(followed.all()[0], 6), 0);
    // One that came later has no rows before.
    for (app::Sections* one : {&followed, &recorded}) one->place(simulation, {{0, 300}, {990, 500}});
    EXPECT_EQ(followed.times_s().size(), 7U) << "the row of this time holds it too";
    for (int i = 0; i < 1000; ++i) followed.follow(simulation);
    EXPECT_EQ(followed.times_s().size(), 7U);
    simulation.apply(Ticks{2});
    take_rows();
    simulation.end_entry();
    EXPECT_EQ(followed.to_csv(), recorded.to_csv());
    EXPECT_NE(followed.to_csv().find("\n0,,0,,\n"), std::string::npos) << followed.to_csv();
    // Undo takes rows back; and a row that was asked for then is no row of this time.
    simulation.apply(Ticks{1});
    followed.follow(simulation);
    simulation.undo();
    for (int i = 0; i < 1000; ++i) followed.follow(simulation);
    EXPECT_EQ(followed.times_s().back(), 40);
    EXPECT_EQ(followed.times_s().size(), 8U);
    // Beside the map there is none, and those that were there go on.
    EXPECT_THROW(followed.place(simulation, {{0, 0}, {5000, 0}}), Error);
    EXPECT_EQ(followed.all().size(), 2U);
    followed.remove(simulation, 0);
    EXPECT_EQ(simulation.section_volumes_m3().size(), 1U);
    followed.remove(simulation, 0);
    EXPECT_TRUE(followed.times_s().empty());
}

}  // namespace
}  // namespace talus::section_test

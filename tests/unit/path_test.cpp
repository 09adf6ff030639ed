// Roads, rivers, walls and ditches: their design along a line of points, and the ground that they make.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "app/core/app_parameters.h"
#include "app/core/bilinear.h"
#include "app/core/path_design.h"
#include "app/core/path_draft.h"
#include "sim/error.h"
#include "sim/gpu/context.h"
#include "sim/journal.h"
#include "sim/simulation.h"
#include "sim/terrain/generate.h"
#include "sim/terrain/state_hash.h"
#include "tests/scenes/parameters_with.h"

namespace talus::path_test {
namespace {

using app::PathDesign;
using app::PathWishes;

const Grid grid{300, 260, 5, 5};

std::vector<float> hills(double relief_m = 150) {
    return generate_heights(grid, {"hills", 5, relief_m});
}

double ground_at(const std::vector<float>& heights, glm::dvec2 place) {
    const glm::dvec2 samples(grid.column_of(place.x), grid.row_of(place.y));
    return app::bilinear(samples, {grid.nx, grid.ny}, [&](int column, int row) {
        return static_cast<double>(heights[static_cast<std::size_t>(row) * grid.nx + column]);
    });
}

const std::vector<glm::dvec2> winding = {{150, 200}, {400, 900}, {700, 500}, {1000, 1000}, {1350, 300}};

PathDesign designed(const std::vector<float>& heights, const PathWishes& wishes) {
    return app::design_path(winding, wishes, grid.dx,
                            [&](glm::dvec2 place) { return ground_at(heights, place); });
}

TEST(Paths, GoSmoothlyThroughTheirPoints) {
    const std::vector<glm::dvec2> line = app::spline_through(winding, 10);
    for (const glm::dvec2 point : winding) {
        double nearest = 1e9;
        for (std::size_t i = 1; i < line.size(); ++i) {
            const glm::dvec2 way = line[i] - line[i - 1];
            const double along =
                std::clamp(glm::dot(point - line[i - 1], way) / glm::dot(way, way), 0.0, 1.0);
            nearest = std::min(nearest, glm::distance(point, line[i - 1] + along * way));
        }
        EXPECT_LT(nearest, 1);
    }
    EXPECT_LT(glm::distance(line.front(), winding.front()), 1e-9);
    EXPECT_LT(glm::distance(line.back(), winding.back()), 1e-9);
    const double step = glm::distance(line[0], line[1]);
    for (std::size_t i = 2; i < line.size(); ++i) {
        const glm::dvec2 before = line[i - 1] - line[i - 2];
        const glm::dvec2 after = line[i] - line[i - 1];
        EXPECT_NEAR(glm::length(after), step, 0.1 * step) << i;
        EXPECT_GT(glm::dot(before, after), 0) << "it turns back at " << i;
    }
    // Two points make a straight line, and equal ones do not break it.
    for (const glm::dvec2 point : app::spline_through({{0, 0}, {100, 50}}, 5))
        EXPECT_NEAR(point.y, point.x / 2, 1e-9);
    for (const glm::dvec2 point : app::spline_through({{3, 4}, {3, 4}}, 5))
        EXPECT_TRUE(std::isfinite(point.x) && std::isfinite(point.y));
    for (const glm::dvec2 point : app::spline_through({{0, 0}, {50, 0}, {50, 0}, {90, 10}}, 5))
        EXPECT_TRUE(std::isfinite(point.x) && std::isfinite(point.y));
}

// Of all lines that keep the grade none strays less: the ground itself rises from one station to another by
// so much more than the grade allows, and half of that must be missed at one of both.
TEST(Paths, ARoadKeepsItsGradeAndStraysLeast) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int trial = 0; trial < 50; ++trial) {
        std::vector<double> stations = {0};
        std::vector<double> ground = {50 * unit(random)};
        for (int i = 1; i < 120; ++i) {
            stations.push_back(stations.back() + 2 + 8 * unit(random));
            ground.push_back(ground.back() + 6 * (unit(random) - 0.45));
        }
        const double grade = 0.02 + 0.2 * unit(random);
        const std::vector<double> road = app::road_profile(stations, ground, grade);
        double least = 0;
        double strays = 0;
        for (std::size_t i = 0; i < road.size(); ++i) {
            strays = std::max(strays, std::abs(road[i] - ground[i]));
            for (std::size_t j = 0; j < i; ++j) {
                const double run = stations[i] - stations[j];
                EXPECT_LE(std::abs(road[i] - road[j]), grade * run * (1 + 1e-9) + 1e-9);
                least = std::max(least, (std::abs(ground[i] - ground[j]) - grade * run) / 2);
            }
        }
        const bool reaches = std::abs(ground.back() - ground.front()) <= grade * stations.back();
        if (reaches) {
            EXPECT_NEAR(road.front(), ground.front(), 1e-9);
            EXPECT_NEAR(road.back(), ground.back(), 1e-9);
            EXPECT_LE(strays, 2 * least + 1e-9);
        } else {
            EXPECT_NEAR(strays, least, 1e-9);
        }
    }
}

TEST(Paths, ARiverFallsAllTheWay) {
    const std::vector<float> heights = hills();
    const PathWishes wishes{.kind = PathKind::river, .depth_m = 3, .least_fall = 0.002};
    const PathDesign design = designed(heights, wishes);
    const std::vector<glm::dvec3>& bed = design.path.points_m;
    for (std::size_t i = 1; i < bed.size(); ++i) {
        const double run = glm::distance(glm::dvec2(bed[i]), glm::dvec2(bed[i - 1]));
        EXPECT_LE(bed[i].z, bed[i - 1].z - 0.002 * run + 1e-9);
    }
    EXPECT_FALSE(design.path.fills);
    EXPECT_GE(design.deepest_cut_m, 3);
}

TEST(Paths, ARoadIsBuiltAsItWasDesigned) {
    const gpu::Context context;
    // So that the sides of two legs do not meet within a bend.
    const std::vector<float> heights = hills(60);
    const PathWishes wishes{.kind = PathKind::road, .width_m = 24, .side_slope = 0.5, .steepest = 0.08};
    const PathDesign design = designed(heights, wishes);
    fmt::print("a road of {:.0f} m: steepest {:.3f}, cut {:.1f} m, fill {:.1f} m\n", design.length_m,
               design.steepest, design.deepest_cut_m, design.highest_fill_m);
    EXPECT_LE(design.steepest, 0.08 + 1e-9);
    EXPECT_GT(design.deepest_cut_m, 2) << "the ground must be steeper than the road";
    Simulation simulation(bedrock_terrain(grid, heights), parameters_with({"maps.count=always"}), 64U << 20U);
    const std::uint64_t before = state_hash(simulation.read());
    simulation.apply(app::dab_of(design));
    const TerrainState end = simulation.read();
    const std::vector<float> after = end.ground();
    // Along its middle, and across its width.
    const std::vector<glm::dvec3>& points = design.path.points_m;
    double worst = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const glm::dvec2 way = glm::normalize(glm::dvec2(points[i]) - glm::dvec2(points[i - 1]));
        for (const double aside : {-6.0, 0.0, 6.0}) {
            const glm::dvec2 place = glm::dvec2(points[i]) + aside * glm::dvec2(-way.y, way.x);
            worst = std::max(worst, std::abs(ground_at(after, place) - points[i].z));
        }
    }
    // Across bends, and between samples, by as much as the road climbs in a few metres.
    EXPECT_LE(worst, 0.08 * 8);
    // Beyond its reach nothing changes, and what changed is no steeper than its sides, or than the ground
    // was.
    std::size_t changed = 0;
    double steepest = 0;
    for (int row = 0; row < grid.ny; ++row)
        for (int column = 0; column + 1 < grid.nx; ++column) {
            const auto at = static_cast<std::size_t>(row) * grid.nx + column;
            if (after[at] == heights[at] || after[at + 1] == heights[at + 1]) continue;
            ++changed;
            const double slope = std::abs(after[at + 1] - after[at]) / grid.dx;
            const double before_slope = std::abs(heights[at + 1] - heights[at]) / grid.dx;
            steepest = std::max(steepest, slope - before_slope);
            const glm::dvec2 place(column * grid.dx, (grid.ny - 1 - row) * grid.dy);
            double nearest = 1e9;
            for (const glm::dvec3& point : points)
                nearest = std::min(nearest, glm::distance(place, glm::dvec2(point)));
            EXPECT_LE(nearest, design.reach_m + 40) << column << " " << row;
        }
    EXPECT_GT(changed, 1500U);
    EXPECT_LE(steepest, 0.5 + 0.08 + 0.05) << "sides and grade together";
    EXPECT_TRUE(design.sides_meet);
    const LedgerReading ledger = simulation.ledger();
    EXPECT_NEAR((ledger.solid_in - ledger.solid_out) / (ledger.solid_final - ledger.solid_initial), 1, 1e-6);
    EXPECT_LT(std::abs(ledger.closing_error_of_moved()), 1e-6);
    double deposited = 0;
    for (const glm::vec4& worn : end.worn_by_hand) deposited += worn.z;
    EXPECT_GT(deposited, 0);
    EXPECT_EQ(name_of(simulation.journal().operations().back()), "road");
    const JournalFile again = read_journal(write_journal({}, simulation.journal()), "a journal");
    EXPECT_EQ(again.operations, simulation.journal().operations());
    simulation.undo();
    EXPECT_EQ(state_hash(simulation.read()), before);
}

// Slopes that slid leave two images that differ: what a path does not reach stays as it is now.
TEST(Paths, LeaveWhatTheyDoNotReach) {
    const gpu::Context context;
    const std::vector<float> heights = generate_heights(grid, {"mountains", 5, 900});
    Simulation simulation(bedrock_terrain(grid, heights),
                          parameters_with({"thermal.on=true", "thermal.repose_deg=20"}), 64U << 20U);
    simulation.apply(Ticks{7});
    simulation.end_entry();
    const std::vector<float> before = simulation.read().ground();
    EXPECT_NE(before, heights);
    PathDesign design = app::design_path({{100, 100}, {1300, 1200}}, {.width_m = 20, .side_slope = 2},
                                         grid.dx, [&](glm::dvec2 place) { return ground_at(before, place); });
    design.reach_m = 60;
    simulation.apply(app::dab_of(design));
    const std::vector<float> after = simulation.read().ground();
    std::size_t astray = 0;
    std::size_t changed = 0;
    for (int row = 0; row < grid.ny; ++row)
        for (int column = 0; column < grid.nx; ++column) {
            const auto i = static_cast<std::size_t>(row) * grid.nx + column;
            const glm::dvec2 place(column * grid.dx, (grid.ny - 1 - row) * grid.dy);
            const glm::dvec2 along = glm::normalize(glm::dvec2(1200, 1100));
            const glm::dvec2 off = place - glm::dvec2(100, 100);
            const bool is_far = std::abs(off.x * along.y - off.y * along.x) > 60;
            changed += after[i] != before[i] ? 1 : 0;
            astray += is_far && after[i] != before[i] ? 1 : 0;
        }
    EXPECT_EQ(astray, 0U);
    EXPECT_GT(changed, 2000U);
    // And goes on sliding as a terrain made anew of it.
    Simulation again(simulation.read(), simulation.parameters());
    for (Simulation* one : {&simulation, &again}) one->apply(Ticks{3});
    EXPECT_EQ(state_hash(simulation.read()), state_hash(again.read()));
}

// On a hillside that is less steep than the sides they meet the ground; on a steeper one that is said.
TEST(Paths, SidesMeetTheHillside) {
    for (const double hillside : {0.4, 1.0}) {
        const auto ground = [&](glm::dvec2 place) { return hillside * place.y; };
        const PathDesign design =
            app::design_path({{100, 500}, {900, 500}}, {.width_m = 10, .side_slope = 0.6}, 5, ground);
        EXPECT_EQ(design.sides_meet, hillside < 0.6);
        EXPECT_NEAR(design.deepest_cut_m, 5 * hillside, 1e-9) << "at the edge of its width";
        EXPECT_NEAR(design.highest_fill_m, 5 * hillside, 1e-9);
        // Uphill: 5 m · 0.4 of cut close at 0.6 - 0.4 a metre.
        EXPECT_TRUE(hillside > 0.6 || std::abs(design.reach_m - 25) < 5.1) << design.reach_m;
        EXPECT_LT(design.misses_m, 1e-9);
    }
    // A climb that is too long for the grade.
    const PathDesign steep =
        app::design_path({{0, 0}, {0, 100}}, {.steepest = 0.1}, 5, [](glm::dvec2 place) { return place.y; });
    EXPECT_NEAR(steep.misses_m, 45, 1);
    // A line is left with few points, none of the others far from it.
    std::vector<glm::dvec3> line;
    for (int i = 0; i <= 1000; ++i) line.emplace_back(i, 3 * std::sin(i / 100.0), 0.02 * i);
    const std::vector<glm::dvec3> few = app::simplified(line, 0.01);
    EXPECT_LT(few.size(), 120U);
    for (const glm::dvec3& point : line) {
        double nearest = 1e9;
        for (std::size_t i = 1; i < few.size(); ++i) {
            const glm::dvec3 way = few[i] - few[i - 1];
            const double share = std::clamp(glm::dot(point - few[i - 1], way) / glm::dot(way, way), 0.0, 1.0);
            nearest = std::min(nearest, glm::distance(point, few[i - 1] + share * way));
        }
        EXPECT_LE(nearest, 0.0101);
    }
}

TEST(Paths, AWallStandsAndADitchIsDug) {
    const gpu::Context context;
    const std::vector<float> heights = hills(30);
    for (const PathKind kind : {PathKind::wall, PathKind::ditch}) {
        Simulation simulation(bedrock_terrain(grid, heights), parameters_with({}));
        simulation.apply(
            app::dab_of(designed(heights, {.kind = kind, .width_m = 20, .depth_m = 4, .height_m = 4})));
        const std::vector<float> after = simulation.read().ground();
        double most = 0;
        for (std::size_t i = 0; i < after.size(); ++i) {
            const double change = (kind == PathKind::wall ? 1 : -1) * (after[i] - heights[i]);
            EXPECT_GE(change, 0);
            most = std::max(most, change);
        }
        // On the level; across a slope one of its edges is higher.
        EXPECT_GT(most, 3.5);
        EXPECT_LT(most, 8);
    }
}

TEST(Paths, AreMovedUntilTheyAreBuilt) {
    const gpu::Context context;
    Simulation simulation(bedrock_terrain(grid, hills()), parameters_with({}));
    Parameters view(app::app_parameters());
    app::PathDraft draft;
    draft.follow(simulation, view, true);
    EXPECT_FALSE(draft.design());
    EXPECT_FALSE(draft.dab(simulation, view));
    for (const glm::dvec2 point : winding) draft.add(point);
    draft.follow(simulation, view, true);
    ASSERT_TRUE(draft.design());
    const double length = draft.design()->length_m;
    EXPECT_EQ(draft.point_near({705, 505}, 10), 2U);
    EXPECT_FALSE(draft.point_near({705, 505}, 5));
    draft.move(2, {700, 100});
    draft.follow(simulation, view, true);
    EXPECT_GT(draft.design()->length_m, length + 100);
    view.set("path.kind", std::string("river"));
    draft.follow(simulation, view, true);
    EXPECT_EQ(draft.design()->path.kind, PathKind::river);
    ASSERT_TRUE(draft.dab(simulation, view));
    EXPECT_NO_THROW(check_dab(*draft.dab(simulation, view)));
    draft.remove_last();
    draft.clear();
    draft.follow(simulation, view, true);
    EXPECT_FALSE(draft.design());
    // Once it is built its points stay, until the next one begins another path.
    draft.add({1, 2});
    draft.add({300, 2});
    draft.set_built(simulation);
    EXPECT_TRUE(draft.is_built(simulation));
    EXPECT_EQ(draft.points_m().size(), 2U);
    draft.add({5, 6});
    EXPECT_EQ(draft.points_m().size(), 1U);
    EXPECT_FALSE(draft.is_built(simulation));
    // After undo they are moved, and more are put.
    draft.add({300, 2});
    draft.set_built(simulation);
    draft.turn_round();
    EXPECT_EQ(draft.points_m().front(), glm::dvec2(300, 2));
    draft.add({7, 8});
    EXPECT_EQ(draft.points_m().size(), 3U);
    // A line of too few points is refused by its name.
    Dab dab;
    dab.effect = PathDab{.points_m = {{0, 0, 0}}};
    EXPECT_THROW(simulation.apply(dab), Error);
}

}  // namespace
}  // namespace talus::path_test

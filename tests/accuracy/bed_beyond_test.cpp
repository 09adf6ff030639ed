// Edges of the water where the ground beyond is known (docs/numerics.md, "Edges of the water").
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "app/claims/arithmetic.h"
#include "app/claims/differing_bits.h"
#include "app/claims/twin_agreement.h"
#include "app/claims/water_scenes.h"
#include "sim/gpu/context.h"
#include "sim/terrain/bed_beyond.h"
#include "sim/terrain/reshape.h"

namespace talus::bed_beyond_test {
namespace {

using scenes::WaterRun;
using scenes::WaterScene;

double volume_of(const TerrainState& state) {
    double sum = 0;
    for (const glm::vec4& water : state.water) sum += static_cast<double>(water.x) + water.y;
    return sum * state.grid.dx * state.grid.dy;
}

// Σ|h - exact| / Σ exact over a part that begins with the whole's first column and row.
double depth_missed(const TerrainState& whole, const TerrainState& part) {
    double missed = 0;
    double all = 0;
    for (int y = 0; y < part.grid.ny; ++y)
        for (int x = 0; x < part.grid.nx; ++x) {
            const double exact = whole.water[static_cast<std::size_t>(y) * whole.grid.nx + x].x;
            missed += std::abs(part.water[static_cast<std::size_t>(y) * part.grid.nx + x].x - exact);
            all += exact;
        }
    return missed / all;
}

// A winding valley that falls eastwards, at some places three times as steep as at others, and water that is
// let go in it.
WaterScene valley(int order) {
    WaterScene scene;
    scene.grid = {220, 64, 5, 5};
    scene.settings.order = order;
    scene.settings.edges.fill(EdgeKind::open);
    scene.settings.manning_s_per_m13 = 0.03;
    scene.bed = [](double x, double y) {
        const double across = y - 160 - 20 * std::sin(x / 150);
        return 40 - 0.02 * x + 0.3 * std::sin(x / 30) + 0.0015 * across * across;
    };
    scene.water = [bed = scene.bed](double x, double y, double) {
        return glm::dvec3(x > 150 && x < 400 ? std::max(0.0, 42 - bed(x, y)) : 0, 0, 0);
    };
    return scene;
}

// Cut across a stream, a part of a valley loses its water as the whole one does at that place: nearer to it
// than over a copy of the bed.
TEST(BedBeyond, AStreamLeavesAPartAsItGoesOnInTheWhole) {
    const gpu::Context context;
    for (const int order : {1, 2}) {
        const WaterScene scene = valley(order);
        TerrainState start = scene.state();
        WaterRun whole(start, scene.settings);
        whole.run(1, 160);
        const TerrainState exact = whole.read();
        double all_known = 0;
        double all_copied = 0;
        for (const int columns : {108, 112, 116, 120, 126, 132}) {
            start.bed_beyond.clear();
            WaterRun copied(cropped(start, {0, 0, columns * 5.0, 1e9}), scene.settings);
            start.bed_beyond.assign(words_of_bed_beyond(start.grid), glsl::unknown_bed);
            WaterRun known(cropped(start, {0, 0, columns * 5.0, 1e9}), scene.settings);
            const double before_m3 = volume_of(known.read());
            for (WaterRun* run : {&known, &copied}) run->run(1, 160);
            const double of_known = depth_missed(exact, known.read());
            const double of_copied = depth_missed(exact, copied.read());
            fmt::print("order {}, cut at column {}: depth L1 {:.4f}, over a copy of the bed {:.4f}\n", order,
                       columns, of_known, of_copied);
            if (order == 2) {
                EXPECT_LT(of_known, of_copied);
            }
            all_known += of_known;
            all_copied += of_copied;
            const WaterBooks books = known.water.read_books(known.terrain.grid());
            EXPECT_NEAR((before_m3 + books.edges_in_m3 - books.edges_out_m3) / volume_of(known.read()), 1,
                        1e-6);
            EXPECT_GT(books.edges_out_m3, 0.01 * before_m3);
        }
        // At order 1 fluxes see no slope of the bed: on ground that falls, a copy is right already.
        if (order == 2)
            EXPECT_LE(all_known, all_copied / 3);
        else
            EXPECT_LE(all_known, 6 * 1e-3);
    }
}

std::size_t moved_bits(const TerrainState& a, const TerrainState& b) {
    return claims::differing_bits(a.water, b.water);
}

// A sea, or a lake that is held, goes on beyond the edge, over a bed that goes up and down there.
TEST(BedBeyond, ASeaThatGoesOnStaysAtRest) {
    const gpu::Context context;
    for (const double datum_m : {0.0, 1000.0})
        for (const EdgeKind kind : {EdgeKind::open, EdgeKind::level, EdgeKind::wave})
            for (const int order : {1, 2}) {
                WaterScene scene = scenes::lake(96, datum_m);
                scene.settings.order = order;
                scene.settings.edges.fill(kind);
                scene.knows_bed_beyond = true;
                const TerrainState start = scene.state();
                double level_m = -1e9;
                std::size_t wet_edges = 0;
                for (int x = 0; x < 96; ++x) {
                    const glm::vec4& water = start.water[static_cast<std::size_t>(x)];
                    if (water.x <= 0) continue;
                    ++wet_edges;
                    level_m = start.ground()[static_cast<std::size_t>(x)] + static_cast<double>(water.x);
                }
                ASSERT_GT(wet_edges, 10U);
                scene.settings.level_m = std::round(level_m * 100) / 100;
                scene.settings.has_sea = true;
                WaterRun run(start, scene.settings);
                run.settings.skips_rest = false;
                run.run(1, 60);
                const WaterBooks books = run.water.read_books(scene.grid);
                SCOPED_TRACE(fmt::format("kind {}, order {}, datum {}, level {}", static_cast<int>(kind),
                                         order, datum_m, scene.settings.level_m));
                EXPECT_EQ(books.edges_in_m3, 0);
                EXPECT_EQ(books.edges_out_m3, 0);
                EXPECT_EQ(moved_bits(run.read(), start), 0U);
            }
}

// Without a sea beyond: a pond reaches the edge, and the ground rises behind it.
TEST(BedBeyond, APondBeforeABankStaysAtRest) {
    const gpu::Context context;
    for (const int order : {1, 2}) {
        WaterScene scene;
        scene.grid = {64, 64, 5, 5};
        scene.settings.order = order;
        scene.settings.edges.fill(EdgeKind::open);
        scene.knows_bed_beyond = true;
        // The edges' samples lie 2.5 m inside; from there on the ground rises by 1 m in 2 m.
        scene.bed = [](double x, double y) {
            const double beyond = std::max({2.5 - x, 2.5 - y, x - 317.5, y - 317.5, 0.0});
            return 0.3 * std::sin(0.11 * x) * std::cos(0.07 * y) + 0.5 * beyond;
        };
        scene.water = [bed = scene.bed](double x, double y, double) {
            return glm::dvec3(2 - bed(x, y), 0, 0);
        };
        const TerrainState start = scene.state();
        WaterRun run(start, scene.settings);
        run.settings.skips_rest = false;
        run.run(1, 60);
        EXPECT_EQ(run.water.read_books(scene.grid).edges_out_m3, 0);
        EXPECT_EQ(moved_bits(run.read(), start), 0U);
    }
}

// A pond on a flat bed ends at a drop of 3 m: until it is noticed at the far wall it is a dam break onto a
// dry bed, which is critical at the brink, where 8/27 √g H^(3/2) leaves (Ritter 1892).
TEST(BedBeyond, APondBeforeADropRunsOut) {
    const gpu::Context context;
    for (const int order : {1, 2})
        for (const double datum_m : {0.0, -400.0}) {
            std::vector<double> off;
            for (const int n : {64, 256}) {
                WaterScene scene;
                scene.grid = {n, 4, 320.0 / n, 320.0 / n};
                scene.settings.order = order;
                scene.settings.edges = {EdgeKind::wall, EdgeKind::wall, EdgeKind::wall, EdgeKind::open};
                scene.bed = [=](double x, double) { return datum_m - (x > 320 ? 3 : 0); };
                scene.water = [](double, double, double) { return glm::dvec3(1, 0, 0); };
                scene.knows_bed_beyond = true;
                WaterRun run(scene.state(), scene.settings);
                run.run(1, 90);
                const double left_m3 = run.water.read_books(scene.grid).edges_out_m3;
                const double expected_m3 = 8.0 / 27 * std::sqrt(9.81) * 4 * scene.grid.dy * 90;
                fmt::print(
                    "a pond of 1 m before a drop, n {}, order {}, at {} m: {:.4f} of Ritter's outflow\n", n,
                    order, datum_m, left_m3 / expected_m3);
                off.push_back(std::abs(left_m3 / expected_m3 - 1));

                // A sea at the pond's level holds it; over a copy of the bed it stood still as well.
                scene.settings.has_sea = true;
                scene.settings.level_m = datum_m + 1;
                WaterRun by_the_sea(scene.state(), scene.settings);
                by_the_sea.run(1, 20);
                EXPECT_EQ(moved_bits(by_the_sea.read(), scene.state()), 0U);
            }
            EXPECT_LE(off[1], 0.02);
            EXPECT_LE(off[1], off[0] / 2);
        }
}

// An inflow that is given, walls and edges that are joined do not depend on it.
TEST(BedBeyond, IsNothingToOtherKindsOfEdges) {
    const gpu::Context context;
    for (const EdgeKind kind : {EdgeKind::wall, EdgeKind::inflow, EdgeKind::periodic}) {
        WaterScene scene = scenes::basin(64, 3);
        scene.settings.edges.fill(kind);
        scene.settings.inflow_m3_per_s = 200;
        scene.knows_bed_beyond = true;
        const TerrainState known = scene.state();
        TerrainState copied = known;
        copied.bed_beyond.clear();
        WaterRun one(known, scene.settings);
        WaterRun other(copied, scene.settings);
        for (WaterRun* run : {&one, &other}) run->run(1, 20);
        EXPECT_EQ(moved_bits(one.read(), other.read()), 0U);
        EXPECT_GT(moved_bits(one.read(), known), 1000U);
    }
}

// No side of the map differs from another: a part that is turned first has the water of one that is turned
// afterwards, but for signs of zeros.
TEST(BedBeyond, TurnsWithTheMap) {
    const gpu::Context context;
    for (const EdgeKind kind : {EdgeKind::open, EdgeKind::level, EdgeKind::wave}) {
        WaterScene scene = scenes::basin(65, 4);
        scene.settings.edges.fill(kind);
        scene.settings.level_m = 2;
        scene.settings.wave_height_m = 0.4;
        scene.settings.wave_period_s = 5;
        scene.knows_bed_beyond = true;
        const TerrainState start = scene.state();
        WaterRun straight(start, scene.settings);
        straight.run(1, 20);
        const TerrainState end = straight.read();
        EXPECT_GT(moved_bits(end, start), 1000U);
        for (const int quarters : {1, 2, 3}) {
            WaterRun run(turned(start, quarters), scene.settings);
            run.run(1, 20);
            EXPECT_EQ(run.read().water, turned(end, quarters).water) << quarters << " quarters";
        }
    }
}

// Held at 0 m, with a bank up to 0.1 m below it beyond the edge, and a low place inside: no more comes in
// than runs over such a bank, which is critical there at most.
TEST(BedBeyond, NoMoreComesInThanRunsOverABank) {
    const gpu::Context context;
    for (const int order : {1, 2}) {
        WaterScene scene;
        scene.grid = {32, 8, 5, 5};
        scene.settings.order = order;
        scene.settings.edges = {EdgeKind::wall, EdgeKind::wall, EdgeKind::level, EdgeKind::wall};
        scene.bed = [](double x, double) { return x < 0 ? -0.1 : -10.0; };
        scene.water = [](double, double, double) { return glm::dvec3(2, 0, 0); };
        scene.knows_bed_beyond = true;
        WaterRun run(scene.state(), scene.settings);
        run.run(1, 60);
        const double came_m3 = run.water.read_books(scene.grid).edges_in_m3;
        const double critical_m3 = 0.1 * std::sqrt(9.81 * 0.1) * 8 * 5 * 60;
        fmt::print("over a bank 0.1 m below the level, order {}: {:.3f} of what is critical\n", order,
                   came_m3 / critical_m3);
        EXPECT_GT(came_m3, 0.3 * critical_m3);
        EXPECT_LE(came_m3, critical_m3 * (1 + 1e-6));
    }
}

TEST(BedBeyond, OpenEdgesBringNothingDownFromIt) {
    const gpu::Context context;
    for (const int order : {1, 2}) {
        WaterScene scene = scenes::rain_on_bowl(100, order);
        scene.knows_bed_beyond = true;
        WaterRun run(scene.state(), scene.settings);
        run.run(scene.tick_s, scene.end_s);
        const WaterBooks books = run.water.read_books(scene.grid);
        fmt::print("rain on a bowl, order {}: {:.2e} of the rain came in by open edges\n", order,
                   books.edges_in_m3 / books.rain_m3);
        EXPECT_EQ(books.edges_in_m3, 0);
    }
}

TEST(BedBeyond, AgreesWithTheFloatTwinToTheBit) {
    const gpu::Context context;
    const bool rounds_as_ieee = claims::arithmetic_of_device().rounds_as_ieee();
    for (const int order : {1, 2}) {
        claims::WaterCase c{order,           0.03,          2e-4, EdgeKind::open, EdgeKind::wave,
                            EdgeKind::level, EdgeKind::open};
        c.knows_bed_beyond = true;
        const claims::TwinAgreement water = water_against_twin(c);
        EXPECT_LT(water.of_double, 1e-4);
        for (const claims::TwinAgreement& agreement : {water, sediment_against_twin(c)}) {
            if (rounds_as_ieee) {
                EXPECT_EQ(agreement.differing, 0U) << "order " << order;
            }
            EXPECT_GT(agreement.changed, agreement.samples / 3);
            EXPECT_LT(agreement.of_double, 1e-3);
            fmt::print("float against double, order {}: L1 {:.1e}\n", order, agreement.of_double);
        }
    }
}

}  // namespace
}  // namespace talus::bed_beyond_test

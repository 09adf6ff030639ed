// Terrain in tiles of several levels: the finest level against exact rays, coarser ones against their bounds.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "render/overview.h"
#include "render/renderer.h"
#include "render/survey.h"
#include "render/tiled/tiled_renderer.h"
#include "sim/error.h"
#include "sim/gpu/context.h"
#include "sim/terrain/generate.h"
#include "tests/scenes/easel.h"
#include "tests/scenes/memory_tiles.h"
#include "tests/scenes/off_pixels.h"
#include "tests/scenes/scenes.h"
#include "tests/scenes/tile_cast_twin.h"
#include "tests/scenes/tiled_easel.h"

namespace talus::tiled_test {
namespace {

constexpr glm::ivec2 size(480, 270);

// From -1 to 1 over the picture, as shaders have it.
glm::vec2 place_of(glm::ivec2 pixel) {
    return 2.0f * (glm::vec2(pixel) + 0.5f) / glm::vec2(size) - 1.0f;
}

template <typename Visit>
void for_pixels(const Visit& visit) {
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) visit(glm::ivec2(x, y), static_cast<std::size_t>(y) * size.x + x);
}

// Whatever sizes the levels of a file have, and also where the coarsest one is several tiles: the samples of
// a tile cover it, and a slot has room for them.
TEST(TileTree, HasRoomForEveryTile) {
    const std::vector<std::vector<glm::ivec2>> files = {
        {{1001, 777}, {500, 388}, {250, 194}, {125, 97}},
        {{1001, 777}, {501, 389}, {251, 195}},
        {{1023, 40}, {511, 20}, {255, 10}, {127, 5}, {63, 2}, {31, 1}},
        {{17, 17}},
        {{2, 2}, {1, 1}},
        {{3000, 100}, {1500, 60}}};
    for (const std::vector<glm::ivec2>& sizes : files) {
        for (const LevelPlaces places : {LevelPlaces::by_count, LevelPlaces::by_halves}) {
            const TileTree tree(Grid{sizes[0].x, sizes[0].y, 1, 1}, 16, sizes, places);
            EXPECT_EQ(tree.first_of(tree.top_level() + 1), tree.count());
            for (std::size_t index = 0; index < tree.count(); ++index) {
                const TileId tile = tree.tile_at(index);
                EXPECT_EQ(tree.index_of(tile), index);
                const glm::dvec2 first = tree.place_in(tile.level, tree.first_patch(tile));
                const glm::dvec2 last = tree.place_in(tile.level, tree.last_patch(tile));
                const TileSamples samples = tree.samples_of(tile);
                const glm::dvec2 from = samples.first;
                const glm::dvec2 to = samples.first + samples.count - 1;
                EXPECT_TRUE(from.x <= first.x - 1 && from.y <= first.y - 1) << index;
                EXPECT_TRUE(to.x >= last.x + 1 && to.y >= last.y + 1) << index;
                EXPECT_LE(std::max(samples.count.x, samples.count.y), tree.room_patches() + 2) << index;
                // Edges lie within the patches that the walk may begin in.
                EXPECT_EQ(glm::ivec2(glm::floor(first)), tree.first_level_patch(tile));
                const glm::dvec2 within = last - glm::dvec2(tree.first_level_patch(tile));
                EXPECT_LT(std::max(within.x, within.y), tree.room_patches()) << index;
            }
        }
    }
    EXPECT_THROW(TileTree(Grid{100, 100, 1, 1}, 20, {{100, 100}}), Error);
    EXPECT_THROW(TileTree(Grid{100, 100, 1, 1}, 16, {{50, 50}}), Error);
    EXPECT_THROW(TileTree(Grid{100, 100, 1, 1}, 16, {}), Error);
}

// The bound of a coarser tile is never below a distance found at random, and not far above the largest one.
TEST(TileBounds, AreNeverTooSmallAndHardlyTooLarge) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0, 1);
    for (const glm::ivec2 samples : {glm::ivec2(130, 97), glm::ivec2(257, 64), glm::ivec2(75, 301)}) {
        const Grid grid{samples.x, samples.y, 3, 5};
        std::vector<float> heights(grid.count());
        for (float& h : heights) h = static_cast<float>(1000 + 40 * unit(random));
        const scenes::MemoryTiles tiles(grid, heights, 16);
        const TileTree& tree = tiles.tree();
        ASSERT_GE(tree.top_level(), 3);
        double tightest = 0;
        for (int level = 1; level <= tree.top_level(); ++level)
            for (int row = 0; row < tree.level(level).tiles.y; ++row)
                for (int column = 0; column < tree.level(level).tiles.x; ++column) {
                    const TileId tile{level, column, row};
                    const glm::dvec2 first = tree.first_patch(tile);
                    const glm::dvec2 last = tree.last_patch(tile);
                    const TileBounds& bounds = tiles.bounds()[tree.index_of(tile)];
                    double most = 0;
                    for (int k = 0; k < 4000; ++k) {
                        glm::dvec2 at = first + (last - first) * glm::dvec2(unit(random), unit(random));
                        if (k % 2 == 0) at = glm::round(at);
                        const double coarse = tiles.height_at(level, at);
                        most = std::max(most, std::abs(coarse - tiles.height_at(0, at)));
                        ASSERT_LE(coarse, bounds.highest_m + 1e-3);
                        ASSERT_GE(coarse, bounds.lowest_m - 1e-3);
                    }
                    ASSERT_LE(most, bounds.error_m);
                    tightest = std::max(tightest, most / bounds.error_m);
                    EXPECT_GT(most, 0.7 * bounds.error_m) << level << " " << column << " " << row;
                }
        std::printf("%d x %d samples: the largest distance found is at most %.4f of the bound\n", samples.x,
                    samples.y, tightest);
    }
}

// Where some samples are others, what else is known holds; the errors are bounds still.
TEST(TileBounds, AreMeasuredAnewWhereSamplesChanged) {
    const Grid grid{777, 601, 10, 10};
    std::mt19937 random(5);
    std::uniform_real_distribution<float> unit(0, 1);
    std::vector<float> heights(grid.count());
    for (float& h : heights) h = 1000 + 40 * unit(random);
    const scenes::MemoryTiles before(grid, heights, 16);
    for (const TileSamples changed : {TileSamples{{300, 200}, {70, 40}}, TileSamples{{0, 590}, {9, 11}}}) {
        std::vector<float> other = heights;
        for (int y = changed.first.y; y < changed.first.y + changed.count.y; ++y)
            for (int x = changed.first.x; x < changed.first.x + changed.count.x; ++x)
                other[static_cast<std::size_t>(y) * grid.nx + x] += 300 * unit(random);
        const scenes::MemoryTiles after(grid, other, 16);
        std::atomic<int> readings = 0;
        const auto read = [&](int level, const TileSamples& samples, std::vector<float>& read_heights) {
            ++readings;
            after.read(level, samples, read_heights);
        };
        const BoundsBefore known{before.bounds(), changed};
        const std::vector<TileBounds> found = measure_tile_bounds(
            after.tree(), [&] { return read; }, {}, &known);
        const int of_some = readings.exchange(0);
        const std::vector<TileBounds> fresh = measure_tile_bounds(after.tree(), [&] { return read; });
        EXPECT_LT(of_some, readings / 3);
        for (std::size_t i = 0; i < fresh.size(); ++i) {
            EXPECT_EQ(found[i].lowest_m, fresh[i].lowest_m) << i;
            EXPECT_EQ(found[i].highest_m, fresh[i].highest_m) << i;
            // What is added for rounding goes by the heights where each error was found.
            const float expected = std::max(fresh[i].error_m, before.bounds()[i].error_m);
            EXPECT_LE(found[i].error_m, expected) << i;
            EXPECT_GE(found[i].error_m, expected - 16 * 1.2e-7F * 300) << i;
        }
    }
}

TEST(TileBounds, EndWhereTheyAreTold) {
    const Grid grid{1025, 257, 1, 1};
    const scenes::MemoryTiles tiles(grid, std::vector<float>(grid.count(), 3), 16);
    int told = 0;
    std::atomic<int> readings = 0;
    const auto read = [&](int level, const TileSamples& samples, std::vector<float>& heights) {
        ++readings;
        tiles.read(level, samples, heights);
    };
    EXPECT_EQ(measure_tile_bounds(tiles.tree(), [&] { return read; }), tiles.bounds());
    const int of_all = readings.exchange(0);
    EXPECT_TRUE(measure_tile_bounds(
                    tiles.tree(), [&] { return read; },
                    [&](double) {
                        ++told;
                        return false;
                    })
                    .empty());
    EXPECT_EQ(told, 1);
    EXPECT_LT(readings, of_all / 2);
    const auto fail = [](int, const TileSamples&, std::vector<float>&) { throw std::runtime_error("gone"); };
    EXPECT_THROW(measure_tile_bounds(tiles.tree(), [&] { return fail; }), std::runtime_error);
}

class Tiled : public ::testing::TestWithParam<std::string> {};

// Law 2: where all tiles are of the finest level, rays over tiles are rays over the whole, bit for bit.
// seeing_ground: so many of the cameras do, at least.
void expect_bits_of_exact(const scenes::Scene& scene, const scenes::MemoryTiles& tiles, int seeing_ground) {
    scenes::TiledEasel easel(tiles, size, static_cast<int>(tiles.tree().count()));
    scenes::Easel whole(scene, size.x, size.y);
    const render::Method method = render::method_named("exact").make(render::Detail::none);
    int with_ground = 0;
    for (const render::NamedCamera& view : render::survey(scene.grid, scene.heights)) {
        easel.load(view.camera, 0);
        const std::vector<float> shown = easel.distances(view.camera);
        const std::vector<float> exact = scenes::distances(whole.draw(method, view.camera, 0));
        int different = 0;
        int hits = 0;
        for_pixels([&](glm::ivec2, std::size_t i) {
            different += shown[i] == exact[i] ? 0 : 1;
            hits += std::isinf(exact[i]) ? 0 : 1;
        });
        EXPECT_EQ(different, 0) << view.name;
        with_ground += hits > 1000 ? 1 : 0;
    }
    EXPECT_GE(with_ground, seeing_ground);
}

TEST_P(Tiled, WithoutToleranceIsExact) {
    const gpu::Context context;
    const scenes::Scene scene = scenes::make(GetParam());
    // The generated terrain that stands for real files has no valley: who looks up there sees sky alone.
    expect_bits_of_exact(scene, scenes::MemoryTiles(scene.grid, scene.heights, 64),
                         GetParam() == "rough" ? 11 : 12);
}

TEST(TiledSurface, WithoutToleranceIsExactOver4096) {
    const gpu::Context context;
    const Grid grid{4096, 4096, 5, 5};
    const scenes::Scene scene = {grid, generate_heights(grid, {"mountains", 4, 2500})};
    expect_bits_of_exact(scene, scenes::MemoryTiles(scene.grid, scene.heights, 256), 12);
}

// No pixel is farther off than the tolerance, whatever levels meet.
TEST_P(Tiled, IsWithinItsTolerance) {
    const gpu::Context context;
    const scenes::Scene scene = scenes::make(GetParam());
    const scenes::MemoryTiles tiles(scene.grid, scene.heights, 32);
    scenes::TiledEasel easel(tiles, size, static_cast<int>(tiles.tree().count()));
    scenes::OffPixels off_px(scene, tiles, size);
    for (const double tolerance_px : {2.0 / 3, 4.0}) {
        std::vector<long> of_level(static_cast<std::size_t>(tiles.tree().top_level()) + 1, 0);
        double largest_px = 0;
        for (const render::NamedCamera& view : render::survey(scene.grid, scene.heights)) {
            const render::TileChoice choice = easel.load(view.camera, tolerance_px);
            EXPECT_EQ(choice.tolerance_px, tolerance_px);
            for (const TileId& tile : choice.drawn) ++of_level[static_cast<std::size_t>(tile.level)];
            off_px.look(view.camera, tolerance_px);
            const std::vector<float> shown = easel.distances(view.camera);
            int beyond = 0;
            for_pixels([&](glm::ivec2 pixel, std::size_t i) {
                if (i % 7 != 0) return;
                const double off = off_px(pixel, shown[i]);
                beyond += off > tolerance_px ? 1 : 0;
                largest_px = std::max(largest_px, off);
            });
            EXPECT_EQ(beyond, 0) << view.name << " at " << tolerance_px << " px";
        }
        std::printf("%s at %.2f px: at most %.2f px off; tiles by level", GetParam().c_str(), tolerance_px,
                    largest_px);
        for (const long count : of_level) std::printf(" %ld", count);
        std::printf("\n");
        // Needles are in no coarser level.
        EXPECT_EQ(of_level[1] > 0, GetParam() != "spikes");
    }
}

// Law 4, and no hole: whichever tiles are there, a picture is the twin's, and straight down over the terrain
// every ray hits.
TEST_P(Tiled, DrawsWhatIsThereAsItsTwin) {
    const gpu::Context context;
    const scenes::Scene scene = scenes::make(GetParam());
    const scenes::MemoryTiles tiles(scene.grid, scene.heights, 32);
    const TileTree& tree = tiles.tree();
    scenes::TiledEasel easel(tiles, size, static_cast<int>(tree.count()));
    std::mt19937 random(11);
    const glm::dvec3 middle(0.5 * scene.grid.width_m(), 0.5 * scene.grid.height_m(), 0);
    const double width_m = std::min(scene.grid.width_m(), scene.grid.height_m());
    const double highest_m = *std::max_element(scene.heights.begin(), scene.heights.end());
    const render::Camera down = {middle + glm::dvec3(0, 0, highest_m + width_m), middle, 10};
    std::vector<render::NamedCamera> views = render::survey(scene.grid, scene.heights);
    views.push_back({"down", down});
    int fallen_back = 0;
    int finer = 0;
    for (const render::NamedCamera& view : views) {
        easel.surface.clear();
        const render::TileChoice wish = easel.surface.look(view.camera, size, 1);
        // Of some the four tiles below, of some nothing.
        for (const TileId& tile : wish.wanted) {
            const auto fate = random() % 3;
            if (fate == 0) easel.put(tile);
            if (fate == 1 && tile.level > 0)
                for (int i = 0; i < 4; ++i) {
                    const TileId below = {tile.level - 1, 2 * tile.column + i % 2, 2 * tile.row + i / 2};
                    const glm::ivec2 tiles_below = tree.level(below.level).tiles;
                    if (below.column < tiles_below.x && below.row < tiles_below.y) easel.put(below);
                }
        }
        const render::TileChoice choice = easel.surface.look(view.camera, size, 1);
        fallen_back += static_cast<int>(choice.wanted.size());
        for (const TileId& tile : choice.wanted)
            finer += std::any_of(
                         choice.nodes.begin(), choice.nodes.end(),
                         [&](const render::TileNode& node) { return node.tile == tile && node.slot == -1; })
                         ? 1
                         : 0;
        const std::vector<float> shown = easel.distances(view.camera);
        const std::vector<float> slots = easel.hit_slots();
        maths::TileCastTwin<float> twin(tiles);
        twin.look(choice, easel.surface, view.camera, size.x, size.y);
        int different = 0;
        int missed = 0;
        for_pixels([&](glm::ivec2 pixel, std::size_t i) {
            missed += std::isinf(shown[i]) ? 1 : 0;
            if (i % 7 != 0) return;
            const glm::vec2 at = place_of(pixel);
            const maths::TileCastTwin<float>::TileHit hit = twin.cast_pixel(at.x, at.y);
            const bool same = shown[i] == hit.distance_m && slots[i] == static_cast<float>(hit.slot);
            different += (hit.distance_m < 0 ? std::isinf(shown[i]) : same) ? 0 : 1;
        });
        EXPECT_EQ(different, 0) << view.name;
        if (view.name == "down") {
            EXPECT_EQ(missed, 0);
        }
    }
    EXPECT_GT(fallen_back, 100);
    EXPECT_EQ(finer > 0, GetParam() != "spikes");
}

// Around a hole the device's hits are the twin's, bit for bit; none lies in the hole, and its walls are
// marked.
TEST_P(Tiled, GoesAroundAHoleAsItsTwin) {
    const gpu::Context context;
    const scenes::Scene scene = scenes::make(GetParam());
    const scenes::MemoryTiles tiles(scene.grid, scene.heights, 16);
    scenes::TiledEasel easel(tiles, size, static_cast<int>(tiles.tree().count()));
    const glm::ivec2 patches(scene.grid.nx - 1, scene.grid.ny - 1);
    const glm::ivec2 first = patches / 3 + 1;
    const glm::ivec2 end = 2 * patches / 3 + 3;
    render::TiledRays rays(first, end);
    const render::HitsTarget target(size.x, size.y);
    int walls = 0;
    for (const render::NamedCamera& view : render::survey(scene.grid, scene.heights)) {
        const render::TileChoice choice = easel.load(view.camera, 1);
        rays.cast(easel.surface, view.camera, size, target.framebuffer());
        const std::vector<float> shown = target.read_distances(size.x, size.y);
        const std::vector<float> details = target.read_details(size.x, size.y);
        maths::TileCastTwin<float> twin(tiles);
        twin.look(choice, easel.surface, view.camera, size.x, size.y);
        int different = 0;
        int in_hole = 0;
        const render::CameraRays way = render::camera_rays(view.camera, size.x, size.y);
        for_pixels([&](glm::ivec2 pixel, std::size_t i) {
            if (i % 5 != 0) return;
            const glm::vec2 at = place_of(pixel);
            const auto hit = twin.cast_pixel_around(first, end, at.x, at.y);
            const float slot = static_cast<float>(hit.slot);
            const float detail = hit.on_wall ? -1 - slot : slot;
            const bool same = shown[i] == hit.distance_m && details[i] == detail;
            different += (hit.distance_m < 0 ? std::isinf(shown[i]) : same) ? 0 : 1;
            walls += hit.on_wall ? 1 : 0;
            if (std::isinf(shown[i])) return;
            const glm::dvec3 point =
                view.camera.eye + static_cast<double>(shown[i]) *
                                      glm::normalize(way.middle + static_cast<double>(at.x) * way.right +
                                                     static_cast<double>(at.y) * way.up);
            const glm::dvec2 place(scene.grid.column_of(point.x), scene.grid.row_of(point.y));
            const glm::dvec2 inside = glm::min(place - glm::dvec2(first), glm::dvec2(end) - place);
            in_hole += std::min(inside.x, inside.y) > 0.02 ? 1 : 0;
        });
        EXPECT_EQ(different, 0) << view.name;
        EXPECT_EQ(in_hole, 0) << view.name;
    }
    EXPECT_GT(walls, 1000);
}

// Where all tiles are of the finest level, each view colours them as it colours the whole, but for rounding.
TEST_P(Tiled, LooksAsTheWhole) {
    const gpu::Context context;
    const scenes::Scene scene = scenes::make(GetParam());
    const scenes::MemoryTiles tiles(scene.grid, scene.heights, 64);
    scenes::TiledEasel easel(tiles, size, static_cast<int>(tiles.tree().count()));
    const Terrain terrain(bedrock_terrain(scene.grid, scene.heights));
    render::Renderer whole(terrain, 8);
    render::TiledRenderer tiled;
    int most = 0;
    for (const render::View& view : render::views()) {
        render::ViewSettings settings;
        settings.method = "exact";
        settings.view = view.name;
        settings.sun = glm::normalize(glm::dvec3(-0.6, 0.5, 0.45));
        settings.occlusion = false;
        for (const std::size_t which : {0U, 4U, 9U}) {
            const render::Camera camera = render::survey(scene.grid, scene.heights)[which].camera;
            easel.load(camera, 0);
            if (!render::is_of_tiles(view)) {
                EXPECT_THROW(tiled.draw(easel.surface, camera, settings, size.x, size.y), Error);
                continue;
            }
            tiled.draw(easel.surface, camera, settings, size.x, size.y);
            whole.draw(terrain, camera, settings, size.x, size.y);
            for (const int samples : {1, 3}) {
                while (tiled.refine(easel.surface, samples)) {
                }
                while (whole.refine(terrain, samples)) {
                }
                const std::vector<std::uint8_t> expected = whole.read_rgb(size.x, size.y);
                const std::vector<std::uint8_t> shown = tiled.read_rgb(size.x, size.y);
                int different = 0;
                for (std::size_t i = 0; i < shown.size(); ++i)
                    different += std::abs(shown[i] - expected[i]) > 2 ? 1 : 0;
                // Steps and kinds are another walk's. At a shadow's edge rounding decides.
                if (view.detail == render::Detail::none) {
                    EXPECT_LT(different, 3 * size.x * size.y / (view.natural ? 500 : 1000))
                        << view.name << " " << which << ", " << samples << " samples";
                }
                most = std::max(most, view.detail == render::Detail::none ? different : 0);
            }
            EXPECT_EQ(tiled.read_depth(size.x, size.y), whole.read_depth(size.x, size.y)) << view.name;
        }
    }
    std::printf("%s: at most %d of %d colours differ by more than 2\n", GetParam().c_str(), most,
                3 * size.x * size.y);
}

INSTANTIATE_TEST_SUITE_P(Terrains, Tiled, ::testing::ValuesIn(scenes::names()),
                         [](const auto& scene) { return scene.param; });

// Where a picture needs more tiles than there is room for, it is coarsened evenly, the same however often it
// is looked at, and no more tiles are held than there are slots.
TEST(TiledSurface, KeepsToItsSlots) {
    const gpu::Context context;
    const scenes::Scene scene = scenes::make("fbm");
    const scenes::MemoryTiles tiles(scene.grid, scene.heights, 32);
    scenes::TiledEasel easel(tiles, size, 30);
    EXPECT_EQ(easel.surface.slots(), 30);
    scenes::OffPixels off_px(scene, tiles, size);
    int coarsened = 0;
    for (const render::NamedCamera& view : render::survey(scene.grid, scene.heights)) {
        const render::TileChoice choice = easel.load(view.camera, 2.0 / 3);
        EXPECT_LE(choice.drawn.size(), 29u) << view.name;
        EXPECT_GE(choice.tolerance_px, 2.0 / 3);
        coarsened += choice.tolerance_px > 2.0 / 3 ? 1 : 0;
        const render::TileChoice again = easel.surface.look(view.camera, size, 2.0 / 3);
        EXPECT_EQ(again.tolerance_px, choice.tolerance_px);
        EXPECT_TRUE(again.wanted.empty()) << view.name;
        off_px.look(view.camera, choice.tolerance_px);
        const std::vector<float> shown = easel.distances(view.camera);
        int beyond = 0;
        for_pixels([&](glm::ivec2 pixel, std::size_t i) {
            if (i % 7 == 0) beyond += off_px(pixel, shown[i]) > choice.tolerance_px ? 1 : 0;
        });
        EXPECT_EQ(beyond, 0) << view.name << " at " << choice.tolerance_px << " px";
    }
    EXPECT_GT(coarsened, 6);
    // One slot and no more is too few.
    EXPECT_THROW(render::TiledSurface(tiles.tree(), tiles.bounds(), 1), Error);
}

// Tiles of the coarsest level have their own room: they don't count against the others'.
TEST(TileChoice, LeavesTheCoarsestTilesTheirRoom) {
    const TileTree tree(Grid{2049, 2049, 10, 10}, 256, {{2049, 2049}, {1025, 1025}});
    ASSERT_EQ(tree.level(tree.top_level()).tiles, glm::ivec2(4));
    std::vector<TileBounds> bounds(tree.count(), {0, 100, 0});
    for (std::size_t i = tree.first_of(1); i < tree.count(); ++i) bounds[i].error_m = 1;
    const auto nothing_finer = [&](const TileId& tile) {
        return tile.level == tree.top_level() ? static_cast<int>(tree.index_of(tile) - tree.first_of(1)) : -1;
    };
    const render::Camera far = {{10000, -40000, 30000}, {10000, 10000, 0}, 50};
    const render::TileChoice from_far = render::choose_tiles(tree, bounds, far, size, 1, 10, nothing_finer);
    EXPECT_EQ(from_far.tolerance_px, 1);
    EXPECT_TRUE(from_far.wanted.empty());
    const render::Camera near = {{5000, 5000, 300}, {10000, 10000, 0}, 50};
    const render::TileChoice from_near = render::choose_tiles(tree, bounds, near, size, 1, 10, nothing_finer);
    EXPECT_LE(from_near.wanted.size(), 10U);
    EXPECT_GT(from_near.wanted.size(), 0U);
}

// A tile that is put aside takes no slot that a picture has a use for, and gives its own to one that is
// wanted.
TEST(TiledSurface, PutsAsideWithoutPushingOut) {
    const gpu::Context context;
    const scenes::Scene scene = scenes::make("fbm");
    const scenes::MemoryTiles tiles(scene.grid, scene.heights, 32);
    const TileTree& tree = tiles.tree();
    scenes::TiledEasel easel(tiles, size, 30);
    const std::vector<render::NamedCamera> views = render::survey(scene.grid, scene.heights);
    int put = 0;
    int dropped = 0;
    for (const render::NamedCamera& view : views) {
        const render::TileChoice choice = easel.load(view.camera, 1);
        const int put_before = put;
        // All tiles of the finest level, many more than there are slots.
        for (std::size_t i = 0; i < tree.first_of(1); ++i) {
            const TileId tile = tree.tile_at(i);
            if (easel.surface.slot_of(tile) >= 0) continue;
            easel.surface.put_aside(tile, tiles.read(tile));
            (easel.surface.slot_of(tile) >= 0 ? put : dropped) += 1;
        }
        // Others that are wanted now take their slots, and no more.
        int wanted = put - put_before;
        for (std::size_t i = tree.first_of(1); i-- > 0 && wanted > 0;) {
            const TileId tile = tree.tile_at(i);
            if (easel.surface.slot_of(tile) >= 0) continue;
            easel.put(tile);
            --wanted;
        }
        for (const TileId& tile : choice.needed) EXPECT_GE(easel.surface.slot_of(tile), 0) << view.name;
        const render::TileChoice again = easel.surface.look(view.camera, size, 1);
        EXPECT_TRUE(again.wanted.empty()) << view.name;
        EXPECT_EQ(again.nodes, choice.nodes) << view.name;
    }
    EXPECT_GT(put, 10);
    EXPECT_GT(dropped, 1000);
}

// The finest tile that is there, and its samples on the device.
TEST(TiledSurface, TellsWhereTheGroundIs) {
    const gpu::Context context;
    const scenes::Scene scene = scenes::make("fbm");
    const scenes::MemoryTiles tiles(scene.grid, scene.heights, 32);
    const TileTree& tree = tiles.tree();
    scenes::TiledEasel easel(tiles, size, 300);
    easel.load(render::survey(scene.grid, scene.heights).front().camera, 2);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<int> of_level(static_cast<std::size_t>(tree.top_level()) + 1, 0);
    for (int k = 0; k < 300; ++k) {
        glm::dvec2 at =
            glm::dvec2(scene.grid.nx - 1, scene.grid.ny - 1) * glm::dvec2(unit(random), unit(random));
        if (k < 4) at = glm::dvec2(k % 2 * (scene.grid.nx - 1), k / 2 * (scene.grid.ny - 1));
        const auto held = easel.surface.finest_at(at);
        ASSERT_TRUE(held);
        ++of_level[static_cast<std::size_t>(held->tile.level)];
        for (int level = 0; level < held->tile.level; ++level) {
            const glm::ivec2 place = glm::min(glm::ivec2(at), glm::ivec2(scene.grid.nx, scene.grid.ny) - 2) /
                                     (tree.side() << level);
            EXPECT_EQ(easel.surface.slot_of({level, place.x, place.y}), -1);
        }
        const TileSamples samples = tree.samples_of(held->tile);
        const glm::dvec2 in = tree.place_in(held->tile.level, at) - glm::dvec2(samples.first);
        const glm::ivec2 patch = glm::min(glm::ivec2(in), samples.count - 2);
        std::vector<float> corners(4);
        held->heights->read({held->corner.x + patch.x, held->corner.y + patch.y, 2, 2},
                            std::as_writable_bytes(std::span(corners)));
        const glm::dvec2 t = in - glm::dvec2(patch);
        const double height = std::lerp(std::lerp<double>(corners[0], corners[1], t.x),
                                        std::lerp<double>(corners[2], corners[3], t.x), t.y);
        EXPECT_NEAR(height, tiles.height_at(held->tile.level, at), 1e-3);
    }
    EXPECT_GT(of_level[0], 5);
    EXPECT_GT(of_level[1] + of_level[2], 20);
    EXPECT_FALSE(easel.surface.finest_at({-0.1, 5}));
    EXPECT_FALSE(easel.surface.finest_at({5, scene.grid.ny - 0.9}));
}

// Far from the eye a float holds fewer parts of a patch: the sides of a wide terrain are rock there too,
// which fades out below, and no ground is seen on them.
TEST(TiledSurface, HasSidesHoweverWideItIs) {
    const gpu::Context context;
    const Grid grid{40001, 17, 1, 1};
    const scenes::MemoryTiles tiles(grid, std::vector<float>(grid.count(), 10), 64);
    scenes::TiledEasel easel(tiles, size, 64);
    render::TiledRenderer tiled;
    render::ViewSettings settings;
    settings.view = "hillshade";
    int below = 0;
    for (const double east_m : {-30000.0, 200.0, 20000.0, 39000.0, 70000.0}) {
        const render::Camera camera = {{east_m, -60000, 9000}, {20000, 0, -6000}, 50};
        easel.load(camera, 1);
        tiled.draw(easel.surface, camera, settings, size.x, size.y);
        const std::vector<std::uint8_t> shown = tiled.read_rgb(size.x, size.y);
        const std::vector<float> depth = tiled.read_depth(size.x, size.y);
        const render::CameraRays rays = render::camera_rays(camera, size.x, size.y);
        int other = 0;
        for (std::size_t i = 0; i < depth.size(); ++i) {
            const glm::dvec2 pixel(i % size.x, size.y - 1 - i / size.x);
            const glm::dvec2 at = 2.0 * (pixel + 0.5) / glm::dvec2(size) - 1.0;
            const glm::dvec3 way = glm::normalize(rays.middle + at.x * rays.right + at.y * rays.up);
            if (std::isinf(depth[i]) || camera.eye.z + depth[i] * way.z > -100) continue;
            ++below;
            // The backdrop of a view that is no picture of nature.
            other += std::abs(shown[3 * i] - 41) > 1 || std::abs(shown[3 * i + 2] - 48) > 1 ? 1 : 0;
        }
        EXPECT_EQ(other, 0) << east_m;
    }
    EXPECT_GT(below, 10000);
}

// A plane has one slope at all levels, so coarse tiles colour it as the whole is coloured, but for the
// outermost samples, beyond which a level is flat.
TEST(TiledSurface, ColoursCoarseTilesBySlopesInMetres) {
    const gpu::Context context;
    scenes::Scene scene{Grid{257, 257, 10, 20}, {}};
    for (int row = 0; row < 257; ++row)
        for (int column = 0; column < 257; ++column)
            scene.heights.push_back(static_cast<float>(3 * column + 8 * (256 - row)));
    const scenes::MemoryTiles tiles(scene.grid, scene.heights, 64);
    scenes::TiledEasel easel(tiles, size, static_cast<int>(tiles.tree().count()));
    const Terrain terrain(bedrock_terrain(scene.grid, scene.heights));
    render::Renderer whole(terrain, 8);
    render::TiledRenderer tiled;
    const render::Camera camera = render::overview(scene.grid, 0, 2816);
    const render::TileChoice choice = easel.load(camera, 16);
    ASSERT_EQ(choice.drawn.size(), 1U);
    ASSERT_EQ(choice.drawn.front().level, 2);
    const render::CameraRays rays = render::camera_rays(camera, size.x, size.y);
    for (const char* view : {"slope", "aspect", "hillshade", "bands"}) {
        render::ViewSettings settings;
        settings.method = "exact";
        settings.view = view;
        tiled.draw(easel.surface, camera, settings, size.x, size.y);
        whole.draw(terrain, camera, settings, size.x, size.y);
        const std::vector<std::uint8_t> expected = whole.read_rgb(size.x, size.y);
        const std::vector<std::uint8_t> shown = tiled.read_rgb(size.x, size.y);
        const std::vector<float> depth = whole.read_depth(size.x, size.y);
        int compared = 0;
        int different = 0;
        for (std::size_t i = 0; i < depth.size(); ++i) {
            const glm::dvec2 pixel(i % size.x, size.y - 1 - i / size.x);
            const glm::dvec2 at = 2.0 * (pixel + 0.5) / glm::dvec2(size) - 1.0;
            const glm::dvec3 way = glm::normalize(rays.middle + at.x * rays.right + at.y * rays.up);
            const glm::dvec3 place = camera.eye + static_cast<double>(depth[i]) * way;
            const glm::dvec2 sample(scene.grid.column_of(place.x), scene.grid.row_of(place.y));
            // A level's samples are four apart here.
            if (!(glm::all(glm::greaterThan(sample, glm::dvec2(8))) &&
                  glm::all(glm::lessThan(sample, glm::dvec2(248)))))
                continue;
            ++compared;
            for (std::size_t k = 0; k < 3; ++k)
                different += std::abs(shown[3 * i + k] - expected[3 * i + k]) > 2 ? 1 : 0;
        }
        EXPECT_GT(compared, 20000) << view;
        // Bands end where a pixel is rounded otherwise.
        EXPECT_LE(different, std::string(view) == "bands" ? compared / 1000 : 0) << view;
    }
}

}  // namespace
}  // namespace talus::tiled_test

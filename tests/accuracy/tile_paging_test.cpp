// Tiles that come while pictures are drawn: frames that never wait, files that fail, room that is too small.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>

#include "render/tiled/tile_paging.h"
#include "sim/error.h"
#include "sim/gpu/context.h"
#include "sim/terrain/generate.h"
#include "tests/scenes/off_pixels.h"
#include "tests/scenes/tiled_easel.h"

namespace talus::tile_paging_test {
namespace {

constexpr glm::ivec2 size(320, 180);

// A terrain in tiles whose file can be slow, or fail.
class PagedTiles {
  public:
    PagedTiles(const Grid& grid, double relief_m, int side)
        : scene{grid, generate_heights(grid, {"mountains", 4, relief_m})},
          tiles(scene.grid, scene.heights, side) {}

    ReadSamples reader() {
        return [this](int level, const TileSamples& samples, std::vector<float>& heights) {
            while (held) std::this_thread::yield();
            if (fails) throw Error("the file 'far.tif' could not be read");
            ++readings;
            tiles.read(level, samples, heights);
        };
    }

    scenes::Scene scene;
    scenes::MemoryTiles tiles;
    std::atomic<bool> held = false;
    std::atomic<bool> fails = false;
    std::atomic<int> readings = 0;
};

// Frames of the same camera until nothing is to come.
template <typename Frame>
void rest(const render::TilePaging& paging, const Frame& frame) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    do {
        frame();
        std::this_thread::yield();
        ASSERT_LT(std::chrono::steady_clock::now(), end) << paging.on_their_way() << " tiles are awaited";
    } while (paging.on_their_way() > 0 || paging.reads() || paging.has_news());
}

// Low over the ground along a line across the terrain, looking ahead and down.
render::Camera on_the_way(const Grid& grid, double share) {
    const glm::dvec3 eye(grid.width_m() * (0.1 + 0.8 * share), 0.45 * grid.height_m(), 3000);
    return {eye, eye + glm::dvec3(1000, 300, -400), 50};
}

// A small case of what the program does with files of any size: 4096 x 4096 samples, tiles of 128, room for
// 20 of them.
TEST(TilePaging, FliesWithinItsRoom) {
    const gpu::Context context;
    PagedTiles paged(Grid{4096, 4096, 5, 5}, 2500, 128);
    scenes::TiledEasel easel(paged.tiles, size, 20);
    render::TilePaging paging(paged.tiles.tree(), paged.reader());
    scenes::OffPixels off_px(paged.scene, paged.tiles, size);
    int waited = 0;
    int looked_at = 0;
    int hits = 0;
    for (int frame = 0; frame < 60; ++frame) {
        const render::Camera camera = on_the_way(paged.scene.grid, frame / 59.0);
        render::TileChoice choice = paging.follow(easel.surface, camera, size, 2.0 / 3);
        EXPECT_LE(choice.drawn.size(), 4 * 20U);
        EXPECT_EQ(easel.surface.slots(), 20);
        waited += paging.on_their_way() > 0 ? 1 : 0;
        easel.distances(camera);
        if (frame % 12 != 0) continue;
        // At rest all tiles come that there is room for, and the picture is as good as is said.
        rest(paging, [&] { choice = paging.follow(easel.surface, camera, size, 2.0 / 3); });
        EXPECT_TRUE(choice.wanted.empty());
        const int readings = paged.readings;
        for (int i = 0; i < 5; ++i)
            rest(paging, [&] { paging.follow(easel.surface, camera, size, 2.0 / 3); });
        EXPECT_EQ(paged.readings, readings) << "tiles push each other out";
        ++looked_at;
        off_px.look(camera, choice.tolerance_px);
        const std::vector<float> shown = easel.distances(camera);
        int beyond = 0;
        for (std::size_t i = 0; i < shown.size(); i += 7) {
            const glm::ivec2 pixel(static_cast<int>(i) % size.x, static_cast<int>(i) / size.x);
            beyond += off_px(pixel, shown[i]) > choice.tolerance_px ? 1 : 0;
            hits += std::isinf(shown[i]) ? 0 : 1;
        }
        EXPECT_EQ(beyond, 0) << "frame " << frame << " at " << choice.tolerance_px << " px";
    }
    EXPECT_EQ(looked_at, 5);
    EXPECT_GT(waited, 5);
    EXPECT_GT(hits, 5000);
}

// While the file gives nothing, frames are drawn of what there is.
TEST(TilePaging, NeverWaitsForAFile) {
    const gpu::Context context;
    PagedTiles paged(Grid{1025, 1025, 10, 10}, 2000, 64);
    scenes::TiledEasel easel(paged.tiles, size, 200);
    paged.held = true;
    render::TilePaging paging(paged.tiles.tree(), paged.reader());
    for (int frame = 0; frame < 20; ++frame) {
        const render::Camera camera = on_the_way(paged.scene.grid, frame / 19.0);
        const render::TileChoice& choice = paging.follow(easel.surface, camera, size, 1);
        EXPECT_EQ(choice.wanted.size(), paging.on_their_way());
        EXPECT_GT(paging.on_their_way(), 5U);
        for (const TileId& tile : choice.drawn) EXPECT_EQ(tile.level, paged.tiles.tree().top_level());
    }
    EXPECT_TRUE(paging.reads());
    EXPECT_FALSE(paging.has_news());
    paged.held = false;
    rest(paging, [&] { paging.follow(easel.surface, on_the_way(paged.scene.grid, 1), size, 1); });
    EXPECT_EQ(paging.on_their_way(), 0U);
}

// A tile that cannot be read is told of once, tried again, and comes back.
TEST(TilePaging, TriesAgainWhatCouldNotBeRead) {
    const gpu::Context context;
    PagedTiles paged(Grid{513, 513, 10, 10}, 2000, 64);
    scenes::TiledEasel easel(paged.tiles, size, 100);
    paged.fails = true;
    render::TilePaging paging(paged.tiles.tree(), paged.reader());
    const render::Camera camera = on_the_way(paged.scene.grid, 0);
    int messages = 0;
    const auto frames_until = [&](const auto& is_so) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
        while (!is_so() && std::chrono::steady_clock::now() < end) {
            const render::TileChoice& choice = paging.follow(easel.surface, camera, size, 1);
            if (paged.fails) {
                EXPECT_EQ(choice.drawn.front().level, paged.tiles.tree().top_level());
            }
            if (const auto message = paging.take_message()) {
                ++messages;
                EXPECT_EQ(*message, paged.fails ? "the file 'far.tif' could not be read; coarser tiles are "
                                                  "shown there, and it is tried again"
                                                : "tiles can be read again");
            }
        }
        return is_so();
    };
    EXPECT_TRUE(frames_until([&] { return paging.failed() > 5 && paging.on_their_way() == 0; }));
    EXPECT_EQ(messages, 1);
    EXPECT_EQ(paged.readings, 0);
    paged.fails = false;
    EXPECT_TRUE(frames_until([&] { return paging.failed() == 0 && !paging.reads(); }));
    EXPECT_EQ(messages, 2);
    EXPECT_TRUE(paging.follow(easel.surface, camera, size, 1).wanted.empty());

    // What no picture wants any more is not counted, and a failure after that is told again.
    paged.fails = true;
    easel.surface.clear();
    EXPECT_TRUE(frames_until([&] { return paging.failed() > 5 && paging.on_their_way() == 0; }));
    EXPECT_EQ(messages, 3);
    const glm::dvec3 above(2500, 2500, 1e7);
    const render::Camera far = {above, above - glm::dvec3(0, 1, 1e7), 50};
    EXPECT_TRUE(paging.follow(easel.surface, far, size, 1).wanted.empty());
    EXPECT_EQ(paging.failed(), 0U);
    EXPECT_FALSE(paging.take_message());
    EXPECT_TRUE(frames_until([&] { return paging.failed() > 5 && paging.on_their_way() == 0; }));
    EXPECT_EQ(messages, 4);
}

// Along a straight way most tiles are there before a picture wants them.
TEST(TilePaging, ReadsAheadOnTheCamerasWay) {
    const gpu::Context context;
    PagedTiles paged(Grid{2049, 2049, 10, 10}, 2500, 64);
    const auto way = [&](int frame) { return on_the_way(paged.scene.grid, 0.3 + 0.002 * frame); };
    // Without it each frame wants what the frame before had no use for.
    scenes::TiledEasel alone(paged.tiles, size, 200);
    alone.load(way(0), 1);
    std::size_t without = 0;
    scenes::TiledEasel easel(paged.tiles, size, 200);
    render::TilePaging paging(paged.tiles.tree(), paged.reader());
    rest(paging, [&] { paging.follow(easel.surface, way(0), size, 1); });
    std::size_t with = 0;
    for (int frame = 1; frame < 100; ++frame) {
        without += alone.surface.look(way(frame), size, 1).wanted.size();
        alone.load(way(frame), 1);
        with += paging.follow(easel.surface, way(frame), size, 1).wanted.size();
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
        while (paging.reads() && std::chrono::steady_clock::now() < end) std::this_thread::yield();
    }
    std::printf("of %zu tiles that came into sight %zu were not there\n", without, with);
    EXPECT_GT(without, 30U);
    EXPECT_LT(with, without / 4);
}

}  // namespace
}  // namespace talus::tile_paging_test

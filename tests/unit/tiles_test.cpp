// A reader of changes misses none, also where the numbers of stamps run out and begin anew.
#include <gtest/gtest.h>

#include <algorithm>

#include "sim/gpu/context.h"
#include "sim/gpu/program.h"
#include "sim/terrain/tiles.h"

namespace talus::tiles_test {
namespace {

int listed(const Tiles& tiles, Tiles::Reader& reader) {
    TileList list(tiles.count());
    tiles.list(Tiles::anything, reader, 0, 0, 1, list);
    return static_cast<int>(list.buffer.read_all<std::uint32_t>()[1]);
}

TEST(Tiles, AreListedOnceForEachReader) {
    const gpu::Context context;
    Tiles tiles({200, 100, 1, 1});
    Tiles::Reader one;
    Tiles::Reader other;
    EXPECT_EQ(listed(tiles, one), 8);
    EXPECT_EQ(listed(tiles, one), 0);
    EXPECT_EQ(listed(tiles, other), 8);
    tiles.mark_all();
    EXPECT_EQ(listed(tiles, other), 8);
    EXPECT_EQ(listed(tiles, one), 8);
    EXPECT_EQ(listed(tiles, one), 0);
}

// A reader may outlive a terrain: of the next one it has read nothing, though that is as old.
TEST(Tiles, OfAnotherTerrainAreUnreadByAReader) {
    const gpu::Context context;
    Tiles tiles({200, 100, 1, 1});
    Tiles::Reader reader;
    EXPECT_EQ(listed(tiles, reader), 8);
    Tiles other({200, 100, 1, 1});
    EXPECT_EQ(listed(other, reader), 8);
    EXPECT_EQ(listed(other, reader), 0);
}

TEST(Tiles, CountAsChangedWhenTheirNumbersBeginAnew) {
    const gpu::Context context;
    constexpr std::uint32_t last_number = 20;
    Tiles tiles({200, 100, 1, 1}, last_number);
    gpu::Program writer("sim/ground.comp");
    Tiles::Reader reader = tiles.reader_now();
    const Tiles::Reader seldom = tiles.reader_now();
    int begun_anew = 0;
    std::uint64_t before = tiles.now();
    for (int i = 0; i < 100; ++i) {
        tiles.bind_for_stamping(writer);
        ASSERT_GT(tiles.now(), before);
        before = tiles.now();
        const std::vector<bool> changed = tiles.read(Tiles::anything, reader);
        // What was stamped in the round before cannot be told from what was not: all is looked at once.
        const auto count = std::count(changed.begin(), changed.end(), true);
        ASSERT_TRUE(count == 0 || count == 8) << i;
        begun_anew += count == 8 ? 1 : 0;
        EXPECT_EQ(listed(tiles, reader), count);
        EXPECT_EQ(listed(tiles, reader), 0);
    }
    EXPECT_EQ(begun_anew, 5);
    const std::vector<bool> changed = tiles.read(Tiles::anything, seldom);
    EXPECT_EQ(std::count(changed.begin(), changed.end(), true), 8);
}

}  // namespace
}  // namespace talus::tiles_test

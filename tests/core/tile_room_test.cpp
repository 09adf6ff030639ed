#include "app/core/tile_room.h"

#include <gtest/gtest.h>

#include <string>

#include "sim/error.h"

namespace talus::app {
namespace {

constexpr std::size_t slot_bytes = 1 << 18;  // four in a MiB

TileTree tree_of_side(int samples) {
    return TileTree(Grid{samples, samples, 1, 1}, 256, halved_levels(glm::ivec2(samples)));
}

TEST(TileRooms, HoldWhatFitsAndNoMoreThanThereAre) {
    const TileTree tree = tree_of_side(4096);
    // 64 without the tree, which takes little.
    EXPECT_EQ(slots_within({"tiles.gpu_mib", 16, "alps.tif"}, tree, slot_bytes), 63);
    EXPECT_EQ(slots_within({"tiles.gpu_mib", 4096, "alps.tif"}, tree, slot_bytes),
              static_cast<int>(tree.count()) + 1);
}

// One more than the coarsest tiles, which are held always.
TEST(TileRooms, AreLargeEnoughWithOneMoreThanTheCoarsestTiles) {
    const TileTree tree(Grid{1024, 1024, 1, 1}, 256, {glm::ivec2(1024)});  // 16 tiles of one level
    EXPECT_EQ(slots_within({"tiles.gpu_mib", 1, "alps.tif"}, tree, (1 << 20) / 18), 17);
    EXPECT_THROW(slots_within({"tiles.gpu_mib", 1, "alps.tif"}, tree, (1 << 20) / 16), Error);
}

TEST(TileRooms, NameTheParameterThatIsTooSmall) {
    const TileTree tree(Grid{4096, 4096, 1, 1}, 256, {glm::ivec2(4096)});  // 256 tiles of one level
    try {
        slots_within({"tiles.gpu_mib", 16, "alps.tif"}, tree, slot_bytes);
        FAIL() << "nothing was thrown";
    } catch (const Error& error) {
        const std::string said = error.what();
        EXPECT_EQ(said.find("tiles.gpu_mib = 16 holds 6"), 0U) << said;
        EXPECT_NE(said.find("'alps.tif'"), std::string::npos) << said;
        EXPECT_NE(said.find("256"), std::string::npos) << said;
    }
}

}  // namespace
}  // namespace talus::app

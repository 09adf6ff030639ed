// Legends of pictures for files.
#include "app/core/legend.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace talus::legend_test {
namespace {

const std::vector<render::Legend> two = {
    {"Depth", 0, 12.5, "m"}, {"Drawn by", 0, 0, "", render::Legend::Scale::none, 0, {{1, "mesh"}}}};

TEST(Legend, LiesInTheLowerRightCornerAndLeavesTheRestAlone) {
    const glm::ivec2 size(640, 360);
    std::vector<std::uint8_t> rgb(3UL * 640 * 360, 100);
    app::draw_legends(two, size, rgb);
    int white = 0;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const std::uint8_t* pixel = &rgb[3 * (static_cast<std::size_t>(y) * 640 + x)];
            if (x < 640 - 280 || y < 360 - 200) {
                ASSERT_EQ(pixel[0], 100) << x << ' ' << y;
            }
            white += pixel[0] > 200 && pixel[1] > 200 && pixel[2] > 200 ? 1 : 0;
        }
    EXPECT_GT(white, 100) << "its words";
}

TEST(Legend, MayBeLargerThanThePicture) {
    for (const glm::ivec2 size :
         {glm::ivec2(1, 1), glm::ivec2(2100, 40), glm::ivec2(40, 2100), glm::ivec2(33, 17)}) {
        std::vector<std::uint8_t> rgb(3UL * size.x * size.y, 100);
        app::draw_legends(two, size, rgb);
        EXPECT_TRUE(std::any_of(rgb.begin(), rgb.end(), [](std::uint8_t v) { return v != 100; }) ||
                    size.x == 1);
    }
}

}  // namespace
}  // namespace talus::legend_test

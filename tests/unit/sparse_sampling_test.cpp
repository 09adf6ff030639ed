// A terrain's heights from few of its samples.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

#include "sim/error.h"
#include "sim/tiled/sparse_sampling.h"

namespace talus::sparse_sampling_test {
namespace {

constexpr float not_known = std::numeric_limits<float>::quiet_NaN();

// Heights by place; counts what is read, and takes so long for each sample.
template <typename Height>
std::function<ReadSamples()> reader_of(Height height, std::atomic<int>& reads,
                                       std::chrono::microseconds wait) {
    return [=, &reads]() -> ReadSamples {
        return [=, &reads](int level, const TileSamples& samples, std::vector<float>& heights) {
            EXPECT_EQ(level, 0);
            EXPECT_EQ(samples.count, glm::ivec2(1));
            heights = {static_cast<float>(height(samples.first.x, samples.first.y))};
            ++reads;
            std::this_thread::sleep_for(wait);
        };
    };
}

float at(const std::vector<float>& heights, glm::ivec2 size, int x, int y) {
    return heights[static_cast<std::size_t>(y) * size.x + x];
}

// With time enough each height is the sample in the middle of its part.
TEST(SparseSampling, ReadsASampleForEachHeight) {
    const glm::ivec2 samples(10000, 4000);
    const glm::ivec2 size(100, 40);
    std::atomic<int> reads = 0;
    const auto height = [](int x, int y) { return 3 * x + 10000 * y; };
    const std::vector<float> heights = sample_sparsely(samples, size, reader_of(height, reads, {}), 60);
    ASSERT_EQ(heights.size(), 4000U);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            ASSERT_EQ(at(heights, size, x, y), static_cast<float>(height(100 * x + 50, 100 * y + 50)));
}

// A slow file is read for no longer than that, and a slope is still one.
TEST(SparseSampling, KeepsToItsTime) {
    const glm::ivec2 samples(51200, 51200);
    const glm::ivec2 size(200, 200);
    std::atomic<int> reads = 0;
    const auto slope = [](int x, int y) { return 0.01 * x - 0.02 * y; };
    constexpr double budget_s = 0.4;
    const auto begin = std::chrono::steady_clock::now();
    const std::vector<float> heights =
        sample_sparsely(samples, size, reader_of(slope, reads, std::chrono::milliseconds(2)), budget_s);
    const double took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    std::printf("%d samples in %.2f s\n", reads.load(), took_s);
    EXPECT_LE(took_s, 3 * budget_s);
    EXPECT_GT(reads, 16);
    EXPECT_LT(reads, 2000);
    // The outermost samples stand for what is beyond them: of four in a row, an eighth of the terrain.
    for (int y = 25; y < 175; ++y)
        for (int x = 25; x < 175; ++x)
            ASSERT_NEAR(at(heights, size, x, y), slope(256 * x + 128, 256 * y + 128), 0.1) << x << ", " << y;
}

// A few are read of a slow file, none of one that is slower still.
TEST(SparseSampling, ReadsAFewOfWhatIsSlow) {
    std::atomic<int> reads = 0;
    const auto flat = [](int, int) { return 7; };
    for (const float h :
         sample_sparsely({5000, 5000}, {60, 60}, reader_of(flat, reads, std::chrono::milliseconds(30)), 0.2))
        ASSERT_EQ(h, 7);
    EXPECT_EQ(reads, 16);
    EXPECT_EQ(sample_sparsely({5000, 2}, {60, 1}, reader_of(flat, reads, {}), 1).size(), 60U);
    reads = 0;
    EXPECT_TRUE(
        sample_sparsely({5000, 5000}, {60, 60}, reader_of(flat, reads, std::chrono::milliseconds(90)), 0.05)
            .empty());
    EXPECT_LT(reads, 12);
}

TEST(SparseSampling, FillsVoids) {
    std::atomic<int> reads = 0;
    const auto holed = [](int x, int) { return x > 2000 && x < 3000 ? not_known : x < 2500 ? 10.0F : 20.0F; };
    for (const float h : sample_sparsely({5000, 5000}, {50, 50}, reader_of(holed, reads, {}), 60))
        ASSERT_TRUE(h >= 10 && h <= 20) << h;
    const auto unknown = [](int, int) { return not_known; };
    EXPECT_TRUE(sample_sparsely({5000, 5000}, {50, 50}, reader_of(unknown, reads, {}), 1).empty());
}

TEST(SparseSampling, SaysWhatCannotBeRead) {
    const auto broken = []() -> ReadSamples {
        return [](int, const TileSamples& samples, std::vector<float>& heights) {
            if (samples.first.y > 3000) throw Error("the file is damaged");
            heights = {1};
        };
    };
    EXPECT_THROW(sample_sparsely({5000, 5000}, {50, 50}, broken, 1), Error);
}

}  // namespace
}  // namespace talus::sparse_sampling_test
